package org.web3d.x3d.sai.geometry3d;

import org.web3d.x3d.sai.X3DGeometryNode;
import org.web3d.x3d.sai.X3DNode;

/** A sphere about the origin (X3D 4.0, clause 13). */
public interface Sphere extends X3DGeometryNode {
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
}
