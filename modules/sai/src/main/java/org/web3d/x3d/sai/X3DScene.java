package org.web3d.x3d.sai;

import java.util.Map;
import org.jspecify.annotations.Nullable;

/** A scene: an execution context with a head, exports and nodes that can be added and removed. */
public interface X3DScene extends X3DExecutionContext {
  /** Sets what a meta element of the head says; a name that is there gets the new content. */
  void addMetaData(String name, String value);

  /** The meta elements of the head: name to content. */
  Map<String, String> getMetaData();

  /** Takes a meta element of the head away. */
  void removeMetaData(String name);

  /**
   * The node that is exported under that name.
   *
   * @throws InvalidNodeException if there is none
   */
  X3DNode getExportedNode(String name);

  /** The names under which nodes are exported. */
  String[] getExportedNodes();

  /**
   * Exports a node.
   *
   * @param name its DEF name in this scene
   * @param exportedName its name for other scenes; null for the same
   */
  void updateExportedNode(String name, @Nullable String exportedName);

  /** Takes an export away. */
  void removeExportedNode(String exportedName);

  /** Adds a node at the end of the top of the scene. */
  void addRootNode(X3DNode node);

  /** Takes a node away from the top of the scene; without effect if it is not there. */
  void removeRootNode(X3DNode node);
}
