package org.web3d.x3d.sai.geometry3d;

import org.web3d.x3d.sai.X3DGeometryNode;
import org.web3d.x3d.sai.X3DNode;

/** A cylinder about the Y axis (X3D 4.0, clause 13). */
public interface Cylinder extends X3DGeometryNode {
  /** Whether only the outside is seen. */
  boolean getSolid();

  /**
   * Sets {@link #getSolid()}. Only while the node is not {@linkplain X3DNode#realize() realized}.
   */
  void setSolid(boolean value);

  /** The radius in metres. */
  float getRadius();

  /**
   * Sets {@link #getRadius()}. Only while the node is not {@linkplain X3DNode#realize() realized}.
   */
  void setRadius(float value);

  /** The height in metres. */
  float getHeight();

  /**
   * Sets {@link #getHeight()}. Only while the node is not {@linkplain X3DNode#realize() realized}.
   */
  void setHeight(float value);

  /** Whether the bottom is there. */
  boolean getBottom();

  /** Sets {@link #getBottom()}. */
  void setBottom(boolean value);

  /** Whether the side is there. */
  boolean getSide();

  /** Sets {@link #getSide()}. */
  void setSide(boolean value);

  /** Whether the top is there. */
  boolean getTop();

  /** Sets {@link #getTop()}. */
  void setTop(boolean value);
}
