package org.web3d.x3d.sai;

/** Sky and ground behind the scene (X3D 4.0, clause 24). */
public interface X3DBackgroundNode extends X3DBindableNode {
  /** The number of elements that {@link #getGroundAngle} writes. */
  int getNumGroundAngle();

  /**
   * The angles from straight down at which the ground colours after the first stand, in radians; go
   * into the first {@link #getNumGroundAngle()} elements of {@code value}.
   */
  void getGroundAngle(float[] value);

  /** Sets {@link #getGroundAngle} to all elements of {@code value}. */
  void setGroundAngle(float[] value);

  /** The number of tuples that {@link #getGroundColor} writes. */
  int getNumGroundColor();

  /**
   * The colours of the ground from straight down upwards; go into the first {@link
   * #getNumGroundColor()} times three elements of {@code value}.
   */
  void getGroundColor(float[] value);

  /** Sets {@link #getGroundColor} to all elements of {@code value}, three for each tuple. */
  void setGroundColor(float[] value);

  /** The number of elements that {@link #getSkyAngle} writes. */
  int getNumSkyAngle();

  /**
   * The angles from straight up at which the sky colours after the first stand, in radians; go into
   * the first {@link #getNumSkyAngle()} elements of {@code value}.
   */
  void getSkyAngle(float[] value);

  /** Sets {@link #getSkyAngle} to all elements of {@code value}. */
  void setSkyAngle(float[] value);

  /** The number of tuples that {@link #getSkyColor} writes. */
  int getNumSkyColor();

  /**
   * The colours of the sky from straight up downwards; go into the first {@link #getNumSkyColor()}
   * times three elements of {@code value}.
   */
  void getSkyColor(float[] value);

  /** Sets {@link #getSkyColor} to all elements of {@code value}, three for each tuple. */
  void setSkyColor(float[] value);

  /** The transparency, 0 to 1. */
  float getTransparency();

  /** Sets {@link #getTransparency()}. */
  void setTransparency(float value);
}
