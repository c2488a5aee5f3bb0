package org.web3d.x3d.sai.interpolation;

import org.web3d.x3d.sai.X3DInterpolatorNode;

/** Interpolates positions in the plane (X3D 4.0, clause 19). */
public interface PositionInterpolator2D extends X3DInterpolatorNode {
  /** The number of tuples that {@link #getKeyValue} writes. */
  int getNumKeyValue();

  /**
   * The positions in the plane, one for each key; go into the first {@link #getNumKeyValue()} times
   * two elements of {@code value}.
   */
  void getKeyValue(float[] value);

  /** Sets {@link #getKeyValue} to all elements of {@code value}, two for each tuple. */
  void setKeyValue(float[] value);

  /** The value last sent; goes into the first two elements of {@code value}. */
  void getValue(float[] value);
}
