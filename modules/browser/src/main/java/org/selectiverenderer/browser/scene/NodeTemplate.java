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
  private volatile @Nullable PartMaker parts;

  /**
   * Makes the template of a node of a file.
   *
   * @param mesh the mesh of a geometry node, empty if it cannot be drawn; null for other nodes
   */
  public NodeTemplate(SourceLocation location, @Nullable Optional<Mesh> mesh) {
    this.location = location;
    this.mesh = mesh;
  }

  /**
   * Sets what makes the nodes in copies that have only those of the file. Not before there is such
   * a copy, as the maker keeps the nodes of the file.
   */
  public void parts(PartMaker maker) {
    parts = maker;
  }

  SourceLocation location() {
    return location;
  }

  /** Returns a new node in a copy. */
  Node make(ParsedNode part) {
    PartMaker maker = parts;
    if (maker == null) {
      throw new IllegalStateException("nothing makes " + part);
    }
    return maker.make(part);
  }

  /** Returns the mesh of a geometry node, empty if it cannot be drawn; null for other nodes. */
  public @Nullable Optional<Mesh> mesh() {
    return mesh;
  }
}
