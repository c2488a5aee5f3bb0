package org.web3d.x3d.sai;

/** The declaration of a prototype (X3D 4.0, 4.4.4). */
public interface X3DProtoDeclaration {
  /** The name of the prototype. */
  String getProtoName() throws InvalidNodeException;

  /** The abstract types of its instances, numbers of {@link X3DNodeTypes}. */
  int[] getNodeType() throws InvalidNodeException;

  /** The fields that its instances have. */
  X3DFieldDefinition[] getFieldDefinitions() throws InvalidNodeException;

  /** A new instance, not realized yet. */
  X3DProtoInstance createInstance() throws InvalidNodeException;

  /** Lets the declaration go; instances live on. */
  void dispose() throws InvalidNodeException;
}
