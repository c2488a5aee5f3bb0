package org.web3d.x3d.sai.interpolation;

import org.web3d.x3d.sai.X3DInterpolatorNode;

/** Interpolates numbers (X3D 4.0, clause 19). */
public interface ScalarInterpolator extends X3DInterpolatorNode {
  /** The number of elements that {@link #getKeyValue} writes. */
  int getNumKeyValue();

  /**
   * The numbers, one for each key; go into the first {@link #getNumKeyValue()} elements of {@code
   * value}.
   */
  void getKeyValue(float[] value);

  /** Sets {@link #getKeyValue} to all elements of {@code value}. */
  void setKeyValue(float[] value);

  /** The value last sent. */
  float getValue();
}
