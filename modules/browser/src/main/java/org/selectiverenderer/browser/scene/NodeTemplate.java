package org.selectiverenderer.browser.scene;

import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.geometry.mesh.Mesh;

/**
 * A template is shared by all nodes that are made from the same node of a file, one for each Inline
 * of the file. A node has its template until one of its own values changes. Templates are compared
 * by identity.
 */
public final class NodeTemplate {
  private final SourceLocation location;
  private final @Nullable Optional<Mesh> mesh;

  /**
   * Makes the template of a node of a file.
   *
   * @param mesh the mesh of a geometry node, empty if it cannot be drawn; null for other nodes
   */
  public NodeTemplate(SourceLocation location, @Nullable Optional<Mesh> mesh) {
    this.location = location;
    this.mesh = mesh;
  }

  SourceLocation location() {
    return location;
  }

  /** Returns the mesh of a geometry node, empty if it cannot be drawn; null for other nodes. */
  public @Nullable Optional<Mesh> mesh() {
    return mesh;
  }
}
