package org.web3d.x3d.sai.geometry3d;

import org.web3d.x3d.sai.X3DGeometryNode;
import org.web3d.x3d.sai.X3DNode;

/** A box about the origin (X3D 4.0, clause 13). */
public interface Box extends X3DGeometryNode {
  /** Whether only the outside is seen. */
  boolean getSolid();

  /**
   * Sets {@link #getSolid()}. Only while the node is not {@linkplain X3DNode#realize() realized}.
   */
  void setSolid(boolean value);

  /** The width, height and depth in metres; goes into the first three elements of {@code value}. */
  void getSize(float[] value);

  /**
   * Sets {@link #getSize}, three elements. Only while the node is not {@linkplain X3DNode#realize()
   * realized}.
   */
  void setSize(float[] value);
}
