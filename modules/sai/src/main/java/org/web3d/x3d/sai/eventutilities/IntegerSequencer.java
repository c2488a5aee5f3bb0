package org.web3d.x3d.sai.eventutilities;

import org.web3d.x3d.sai.X3DSequencerNode;

/** Sends integers in sequence (X3D 4.0, clause 30). */
public interface IntegerSequencer extends X3DSequencerNode {
  /** The number of elements that {@link #getKeyValue} writes. */
  int getNumKeyValue();

  /**
   * The values, one for each key; go into the first {@link #getNumKeyValue()} elements of {@code
   * value}.
   */
  void getKeyValue(int[] value);

  /** Sets {@link #getKeyValue} to all elements of {@code value}. */
  void setKeyValue(int[] value);

  /** The value last sent. */
  int getValue();
}
