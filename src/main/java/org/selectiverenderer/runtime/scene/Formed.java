package org.selectiverenderer.runtime.scene;

import java.util.Optional;
import java.util.function.Function;
import org.selectiverenderer.geometry.mesh.Mesh;

/**
 * A node that is drawn like a Shape, with an {@code appearance}, but makes its own mesh. It tells
 * its observers when there is another one.
 */
public interface Formed {
  /** What is drawn now, in local coordinates; the same object until it changes. */
  Optional<Mesh> form();

  /**
   * Where the meshes of geometry nodes in it come from; told once, before it is drawn.
   *
   * @param meshes the mesh of a geometry node as its fields are
   */
  void meshes(Function<Node, Optional<Mesh>> meshes);
}
