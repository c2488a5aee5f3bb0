package org.selectiverenderer.browser.scene;

import java.util.Optional;
import java.util.function.Function;
import org.selectiverenderer.geometry.mesh.Mesh;

/**
 * A node that is drawn like a Shape, with an {@code appearance}, but generates its own mesh:
 * ParticleSystem, InstancedShape. It notifies its observers of a new mesh.
 */
public interface ProceduralShape {
  /** Returns the present mesh in local coordinates; the same object until it changes. */
  Optional<Mesh> form();

  /**
   * Sets the source of meshes for geometry nodes in it; called once, before it is drawn.
   *
   * @param meshes returns the mesh of a geometry node for its present fields
   */
  void meshes(Function<Node, Optional<Mesh>> meshes);
}
