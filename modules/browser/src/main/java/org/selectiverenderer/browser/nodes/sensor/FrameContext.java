package org.selectiverenderer.browser.nodes.sensor;

import java.util.List;
import org.joml.FrustumIntersection;
import org.joml.Matrix4dc;
import org.joml.Quaterniondc;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.scene.Node;

/** The state of a frame that nodes may use. In world coordinates and the scene's unit of length. */
public interface FrameContext {
  /** Returns the frame's time in seconds, which is the cascade's time stamp. */
  double time();

  /** Returns the viewer's eye. */
  Vector3dc eye();

  /** Returns the rotation from the viewer's frame (looking along -Z) to the world. */
  Quaterniondc orientation();

  /** Returns the viewer's view frustum, in world coordinates. */
  FrustumIntersection frustum();

  /**
   * Returns the bound viewpoint's centerOfRotation in world coordinates; null while the navigation
   * type does not use one (X3D 4.0, 22.4.1).
   */
  default @Nullable Vector3dc centerOfRotation() {
    return null;
  }

  /**
   * Returns the matrices from a node's local coordinates to the world, one per instance, in
   * document order. Empty if the node is in no part of the scene.
   */
  List<? extends Matrix4dc> places(Node node);

  /** Returns the matrices of those instances of a node that no group above hides. */
  default List<? extends Matrix4dc> shownPlaces(Node node) {
    return places(node);
  }
}
