package org.web3d.x3d.sai;

import org.jspecify.annotations.Nullable;

/**
 * Nodes, names and routes that belong together: a scene or the body of a prototype. Every method
 * throws {@link InvalidExecutionContextException} once it is disposed of.
 */
public interface X3DExecutionContext {
  /** No scene is there. */
  int NO_SCENE = 0;

  /** Made by a program. */
  int SCRIPTED_ENCODING = 1;

  /** Read from a text encoding not named here. */
  int ASCII_ENCODING = 2;

  /** Read from the classic encoding. */
  int VRML_ENCODING = 3;

  /** Read from the XML encoding. */
  int XML_ENCODING = 4;

  /** Read from the binary encoding. */
  int BINARY_ENCODING = 5;

  /** Read from MPEG-4 BIFS. */
  int BIFS_ENCODING = 6;

  /** Numbers up to this one belong to the standard. */
  int LAST_STD_ENCODING = 127;

  /** The version of X3D that the scene is written in, for example {@code 4.0}. */
  String getSpecificationVersion();

  /** The encoding that the scene was read from, one of the constants. */
  int getEncoding();

  /** The profile of the scene; null if it names none. */
  @Nullable ProfileInfo getProfile();

  /** The components that the scene names beside its profile. */
  ComponentInfo[] getComponents();

  /** Where the scene came from, as a full address; empty when a program made it. */
  String getWorldURL() throws InvalidBrowserException;

  /** All routes of the scene. */
  X3DRoute[] getRoutes();

  /**
   * Adds a route; one that is there already is handed out again.
   *
   * @throws InvalidReadableFieldException if the first field sends no events
   * @throws InvalidWritableFieldException if the second field receives none, or of another type
   */
  X3DRoute addRoute(X3DNode fromNode, String readableField, X3DNode toNode, String writableField)
      throws InvalidBrowserException,
          InvalidReadableFieldException,
          InvalidWritableFieldException,
          InvalidNodeException;

  /** Takes a route away; without effect if it is not there. */
  void removeRoute(X3DRoute route) throws InvalidBrowserException;

  /** The names of all prototypes. */
  String[] getProtosNames();

  /**
   * The prototype of that name.
   *
   * @throws InvalidProtoException if there is none
   */
  X3DProtoDeclaration getProtoDeclaration(String name);

  /** Gives a prototype a name, which it takes from another if need be. */
  void updateProtoDeclaration(String name, X3DProtoDeclaration declaration);

  /** Takes the name of a prototype away. */
  void removeProtoDeclaration(String name);

  /** The names of all external prototypes. */
  String[] getExternProtoNames();

  /**
   * The external prototype of that name.
   *
   * @throws InvalidProtoException if there is none
   */
  X3DExternProtoDeclaration getExternProtoDeclaration(String name);

  /** Gives an external prototype a name, which it takes from another if need be. */
  void updateExternProtoDeclaration(String name, X3DExternProtoDeclaration declaration);

  /** Takes the name of an external prototype away. */
  void removeExternProtoDeclaration(String name);

  /** The DEF names of all named nodes. */
  String[] getNamedNodes();

  /**
   * The node of that DEF name.
   *
   * @throws InvalidNodeException if there is none
   */
  X3DNode getNamedNode(String name);

  /**
   * The node that is imported under that name.
   *
   * @throws InvalidNodeException if there is none
   * @throws NodeUnavailableException if its file is not loaded
   */
  X3DNode getImportedNode(String name);

  /** Takes an import away. */
  void removeImportedNode(String name);

  /**
   * Imports an exported node of an Inline.
   *
   * @param exportedName its name in the scene of the Inline
   * @param name its name here
   * @param inline the Inline
   */
  void updateImportedNode(String exportedName, String name, X3DNode inline);

  /** Gives a node a DEF name, which it takes from another if need be. */
  void updateNamedNode(String name, X3DNode node);

  /** Takes a DEF name away; the node stays. */
  void removeNamedNode(String name);

  /** The nodes at the top of the scene, in order. */
  X3DNode[] getRootNodes();

  /**
   * A new node, not realized and not part of the scene yet.
   *
   * @throws InvalidNodeException if there is no node type of that name
   */
  X3DNode createNode(String name);

  /**
   * A new instance of a prototype of the scene.
   *
   * @throws InvalidProtoException if there is no prototype of that name
   */
  X3DProtoInstance createProto(String name);

  /** Lets the scene go. Xj3D lacks this: a program that is to run on Xj3D does not call it. */
  void dispose();
}
