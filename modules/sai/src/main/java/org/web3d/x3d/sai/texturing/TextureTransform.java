package org.web3d.x3d.sai.texturing;

import org.web3d.x3d.sai.X3DTextureTransformNode;

/** Texture coordinates moved, turned and scaled (X3D 4.0, clause 18). */
public interface TextureTransform extends X3DTextureTransformNode {
  /**
   * The point about which scale and rotation act; goes into the first two elements of {@code
   * value}.
   */
  void getCenter(float[] value);

  /** Sets {@link #getCenter}, two elements. */
  void setCenter(float[] value);

  /** The rotation in radians. */
  float getRotation();

  /** Sets {@link #getRotation()}. */
  void setRotation(float value);

  /** The factors in s and t; goes into the first two elements of {@code value}. */
  void getScale(float[] value);

  /** Sets {@link #getScale}, two elements. */
  void setScale(float[] value);

  /** The translation; goes into the first two elements of {@code value}. */
  void getTranslation(float[] value);

  /** Sets {@link #getTranslation}, two elements. */
  void setTranslation(float[] value);
}
