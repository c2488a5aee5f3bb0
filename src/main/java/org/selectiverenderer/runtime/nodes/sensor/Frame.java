package org.selectiverenderer.runtime.nodes.sensor;

import java.util.List;
import org.joml.FrustumIntersection;
import org.joml.Matrix4dc;
import org.joml.Quaterniondc;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.runtime.scene.Node;

/** What nodes may know of a frame. World coordinates, the scene's unit of length. */
public interface Frame {
  /** The frame's time in seconds; the same as the cascade's. */
  double time();

  /** The viewer's eye. */
  Vector3dc eye();

  /** Takes the viewer's frame (looking along -Z) to the world's. */
  Quaterniondc orientation();

  /** What the viewer can see, in world coordinates. */
  FrustumIntersection frustum();

  /**
   * What the viewer turns about, in world coordinates: the bound viewpoint's centerOfRotation. Null
   * while the way of navigating has none (X3D 4.0, 22.4.1).
   */
  default @Nullable Vector3dc centerOfRotation() {
    return null;
  }

  /**
   * The places of a node: from its local coordinates to the world, one matrix per instance, in
   * document order. Empty when it is in no part of the scene.
   */
  List<? extends Matrix4dc> places(Node node);

  /** Those of its places where nothing above hides it. */
  default List<? extends Matrix4dc> shownPlaces(Node node) {
    return places(node);
  }
}
