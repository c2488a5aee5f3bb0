package org.web3d.x3d.sai;

/** A route from a field that sends events to one that receives them (X3D 4.0, 4.4.8.2). */
public interface X3DRoute {
  /** The node at the start. */
  X3DNode getSourceNode();

  /** The name of the field at the start. */
  String getSourceField();

  /** The node at the end. */
  X3DNode getDestinationNode();

  /** The name of the field at the end. */
  String getDestinationField();
}
