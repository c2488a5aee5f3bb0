package org.web3d.x3d.sai.interpolation;

import org.web3d.x3d.sai.X3DInterpolatorNode;

/** Interpolates sets of unit vectors (X3D 4.0, clause 19). */
public interface NormalInterpolator extends X3DInterpolatorNode {
  /** The number of tuples that {@link #getKeyValue} writes. */
  int getNumKeyValue();

  /**
   * The sets of unit vectors, as many for each key; go into the first {@link #getNumKeyValue()}
   * times three elements of {@code value}.
   */
  void getKeyValue(float[] value);

  /** Sets {@link #getKeyValue} to all elements of {@code value}, three for each tuple. */
  void setKeyValue(float[] value);

  /** The number of tuples that {@link #getValue} writes. */
  int getNumValue();

  /**
   * The value last sent; go into the first {@link #getNumValue()} times three elements of {@code
   * value}.
   */
  void getValue(float[] value);
}
