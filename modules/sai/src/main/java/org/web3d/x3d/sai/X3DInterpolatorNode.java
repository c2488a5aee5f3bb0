package org.web3d.x3d.sai;

/** A node that interpolates linearly between key values (X3D 4.0, clause 19). */
public interface X3DInterpolatorNode extends X3DChildNode {
  /** The number of elements that {@link #getKey} writes. */
  int getNumKey();

  /**
   * The keys in ascending order; go into the first {@link #getNumKey()} elements of {@code value}.
   */
  void getKey(float[] value);

  /** Sets {@link #getKey} to all elements of {@code value}. */
  void setKey(float[] value);

  /** Sets the fraction for which the value is to be sent. */
  void setFraction(float value);
}
