package org.web3d.x3d.sai;

import org.jspecify.annotations.Nullable;

/** A node of a scene (X3D 4.0, clause 7). */
public interface X3DNode {
  /**
   * Sets the metadata; null takes it away.
   *
   * @throws InvalidNodeException if the object is no metadata node
   */
  void setMetadata(@Nullable X3DMetadataObject node);

  /** The metadata node, or null. */
  @Nullable X3DMetadataObject getMetadata();

  /**
   * The name of the node's type, for example {@code Switch}; not its DEF name, which the SAI does
   * not tell.
   */
  String getNodeName() throws InvalidNodeException;

  /** The definitions of all fields that the node has. */
  X3DFieldDefinition[] getFieldDefinitions() throws InvalidNodeException;

  /**
   * Ends the setting up of a newly created node: initializeOnly fields are fixed from here on.
   * Adding a node to a scene realizes it.
   */
  void realize() throws InvalidNodeException;

  /** Whether the setting up of the node has ended. */
  boolean isRealized() throws InvalidNodeException;

  /** The abstract types of the node, numbers of {@link X3DNodeTypes}. */
  int[] getNodeType() throws InvalidNodeException;

  /**
   * The field of that name, also by its event names {@code set_x} and {@code x_changed}. The object
   * also implements the interface of the field's type, such as {@link SFTime}.
   *
   * @throws InvalidFieldException if there is none
   */
  X3DField getField(String name) throws InvalidFieldException, InvalidNodeException;

  /** Lets the node go; every later call throws {@link InvalidNodeException}. */
  void dispose() throws InvalidNodeException;
}
