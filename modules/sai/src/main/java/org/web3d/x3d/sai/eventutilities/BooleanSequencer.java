package org.web3d.x3d.sai.eventutilities;

import org.web3d.x3d.sai.X3DSequencerNode;

/** Sends booleans in sequence (X3D 4.0, clause 30). */
public interface BooleanSequencer extends X3DSequencerNode {
  /** The number of elements that {@link #getKeyValue} writes. */
  int getNumKeyValue();

  /**
   * The values, one for each key; go into the first {@link #getNumKeyValue()} elements of {@code
   * value}.
   */
  void getKeyValue(boolean[] value);

  /** Sets {@link #getKeyValue} to all elements of {@code value}. */
  void setKeyValue(boolean[] value);

  /** The value last sent. */
  boolean getValue();
}
