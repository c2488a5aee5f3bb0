package org.web3d.x3d.sai.navigation;

import org.jspecify.annotations.Nullable;
import org.web3d.x3d.sai.X3DGroupingNode;
import org.web3d.x3d.sai.X3DNode;
import org.web3d.x3d.sai.X3DSensorNode;

/**
 * Children through which the viewer may or may not walk (X3D 4.0, clause 23): {@link #getEnabled()}
 * says which.
 */
public interface Collision extends X3DGroupingNode, X3DSensorNode {
  /** The node against which the viewer collides in place of the children, or null. */
  @Nullable X3DNode getProxy();

  /**
   * Sets {@link #getProxy()}; null empties the field. Only while the node is not {@linkplain
   * X3DNode#realize() realized}.
   */
  void setProxy(@Nullable X3DNode value);

  /** The time of the last collision, in seconds. */
  double getCollideTime();
}
