package org.web3d.x3d.sai;

/** A node that sends one of several discrete values (X3D 4.0, clause 30). */
public interface X3DSequencerNode extends X3DChildNode {
  /** Sets off the value before the present one, on true. */
  void setPrevious(boolean value);

  /** Sets off the value after the present one, on true. */
  void setNext(boolean value);

  /** Sets the fraction whose key value is to be sent. */
  void setFraction(float value);

  /** The number of elements that {@link #getKey} writes. */
  int getNumKey();

  /**
   * The keys in ascending order; go into the first {@link #getNumKey()} elements of {@code value}.
   */
  void getKey(float[] value);

  /** Sets {@link #getKey} to all elements of {@code value}. */
  void setKey(float[] value);
}
