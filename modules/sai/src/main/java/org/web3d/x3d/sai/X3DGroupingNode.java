package org.web3d.x3d.sai;

/** A node that holds children and sets up a coordinate system for them (X3D 4.0, clause 10). */
public interface X3DGroupingNode extends X3DChildNode, X3DBoundedObject {
  /** The number of nodes that {@link #getChildren} writes. */
  int getNumChildren();

  /**
   * The children in order; go into the first {@link #getNumChildren()} elements of {@code value}.
   */
  void getChildren(X3DNode[] value);

  /** Sets {@link #getChildren} to all elements of {@code value}. */
  void setChildren(X3DNode[] value);

  /** Adds children at the end; one that is there already is not added again. */
  void addChildren(X3DNode[] value);

  /** Takes children away; one that is not there is passed over. */
  void removeChildren(X3DNode[] value);
}
