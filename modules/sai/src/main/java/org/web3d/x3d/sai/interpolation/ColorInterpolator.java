package org.web3d.x3d.sai.interpolation;

import org.web3d.x3d.sai.X3DInterpolatorNode;

/** Interpolates colours (X3D 4.0, clause 19). */
public interface ColorInterpolator extends X3DInterpolatorNode {
  /** The number of tuples that {@link #getKeyValue} writes. */
  int getNumKeyValue();

  /**
   * The colours, one for each key; go into the first {@link #getNumKeyValue()} times three elements
   * of {@code value}.
   */
  void getKeyValue(float[] value);

  /** Sets {@link #getKeyValue} to all elements of {@code value}, three for each tuple. */
  void setKeyValue(float[] value);

  /** The value last sent; goes into the first three elements of {@code value}. */
  void getValue(float[] value);
}
