package org.web3d.x3d.sai;

import org.jspecify.annotations.Nullable;

/** A two-dimensional image on a surface (X3D 4.0, clause 18). */
public interface X3DTexture2DNode extends X3DTextureNode {
  /** The node that says how the image is filtered, or null. */
  @Nullable X3DNode getTextureProperties();

  /** Sets {@link #getTextureProperties()}; null empties the field. */
  void setTextureProperties(@Nullable X3DNode value);

  /** Whether the image repeats in the direction of s. */
  boolean getRepeatS();

  /**
   * Sets {@link #getRepeatS()}. Only while the node is not {@linkplain X3DNode#realize() realized}.
   */
  void setRepeatS(boolean value);

  /** Whether the image repeats in the direction of t. */
  boolean getRepeatT();

  /**
   * Sets {@link #getRepeatT()}. Only while the node is not {@linkplain X3DNode#realize() realized}.
   */
  void setRepeatT(boolean value);
}
