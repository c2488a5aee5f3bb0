package org.web3d.x3d.sai.interpolation;

import org.web3d.x3d.sai.X3DInterpolatorNode;

/** Interpolates orientations (X3D 4.0, clause 19). */
public interface OrientationInterpolator extends X3DInterpolatorNode {
  /** The number of tuples that {@link #getKeyValue} writes. */
  int getNumKeyValue();

  /**
   * The orientations, axis and angle in radians, one for each key; go into the first {@link
   * #getNumKeyValue()} times four elements of {@code value}.
   */
  void getKeyValue(float[] value);

  /** Sets {@link #getKeyValue} to all elements of {@code value}, four for each tuple. */
  void setKeyValue(float[] value);

  /** The value last sent; goes into the first four elements of {@code value}. */
  void getValue(float[] value);
}
