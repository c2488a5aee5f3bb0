package org.web3d.x3d.sai.grouping;

import org.web3d.x3d.sai.X3DBoundedObject;
import org.web3d.x3d.sai.X3DChildNode;
import org.web3d.x3d.sai.X3DNode;

/** Children that never change, so that the browser may rearrange them (X3D 4.0, clause 10). */
public interface StaticGroup extends X3DChildNode, X3DBoundedObject {
  /** The number of nodes that {@link #getChildren} writes. */
  int getNumChildren();

  /**
   * The children in order; go into the first {@link #getNumChildren()} elements of {@code value}.
   */
  void getChildren(X3DNode[] value);

  /**
   * Sets {@link #getChildren} to all elements of {@code value}. Only while the node is not
   * {@linkplain X3DNode#realize() realized}.
   */
  void setChildren(X3DNode[] value);
}
