package org.web3d.x3d.sai.grouping;

import org.web3d.x3d.sai.X3DGroupingNode;

/**
 * Children in a coordinate system of their own (X3D 4.0, clause 10): scaled, then turned, then
 * moved.
 */
public interface Transform extends X3DGroupingNode {
  /**
   * The point about which scale and rotation act, in metres; goes into the first three elements of
   * {@code value}.
   */
  void getCenter(float[] value);

  /** Sets {@link #getCenter}, three elements. */
  void setCenter(float[] value);

  /**
   * The rotation, as axis and angle in radians; goes into the first four elements of {@code value}.
   */
  void getRotation(float[] value);

  /** Sets {@link #getRotation}, four elements. */
  void setRotation(float[] value);

  /** The factors in x, y and z; goes into the first three elements of {@code value}. */
  void getScale(float[] value);

  /** Sets {@link #getScale}, three elements. */
  void setScale(float[] value);

  /**
   * The turn of the axes along which the scale acts, as axis and angle in radians; goes into the
   * first four elements of {@code value}.
   */
  void getScaleOrientation(float[] value);

  /** Sets {@link #getScaleOrientation}, four elements. */
  void setScaleOrientation(float[] value);

  /** The translation in metres; goes into the first three elements of {@code value}. */
  void getTranslation(float[] value);

  /** Sets {@link #getTranslation}, three elements. */
  void setTranslation(float[] value);
}
