package org.selectiverenderer.browser.scene;

import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.x3d.read.ParsedNode;

/**
 * A template is shared by all nodes that are made from the same node of a file, one for each Inline
 * of the file. A node has its template until one of its own values changes. Templates are compared
 * by identity.
 */
public final class NodeTemplate {
  /** Makes the nodes in a node whose values are still those of the file. */
  @FunctionalInterface
  public interface PartMaker {
    /** Returns a new node, with all nodes in it. Is called by any thread. */
    Node make(ParsedNode part);
  }

  private final SourceLocation location;
  private final @Nullable Optional<Mesh> mesh;
  private final @Nullable PartMaker parts;

  /**
   * Makes the template of a node of a file.
   *
   * @param mesh the mesh of a geometry node, empty if it cannot be drawn; null for other nodes
   */
  public NodeTemplate(SourceLocation location, @Nullable Optional<Mesh> mesh) {
    this(location, mesh, null);
  }

  /**
   * Makes the template of a node of a file, in whose copies the nodes are made when they are asked
   * for.
   *
   * @param mesh the mesh of a geometry node, empty if it cannot be drawn; null for other nodes
   * @param parts makes the nodes in a copy; null if they are made with it
   */
  public NodeTemplate(
      SourceLocation location, @Nullable Optional<Mesh> mesh, @Nullable PartMaker parts) {
    this.location = location;
    this.mesh = mesh;
    this.parts = parts;
  }

  SourceLocation location() {
    return location;
  }

  /** Returns a new node in a copy. */
  Node make(ParsedNode part) {
    if (parts == null) {
      throw new IllegalStateException("the nodes in " + part + " are made with it");
    }
    return parts.make(part);
  }

  /** Returns the mesh of a geometry node, empty if it cannot be drawn; null for other nodes. */
  public @Nullable Optional<Mesh> mesh() {
    return mesh;
  }
}
