package org.selectiverenderer.runtime;

import java.util.List;
import java.util.Optional;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.runtime.instance.InstanceTree;
import org.selectiverenderer.runtime.instance.Occurrence;
import org.selectiverenderer.runtime.navigation.Viewer;
import org.selectiverenderer.runtime.nodes.BindStacks;
import org.selectiverenderer.runtime.scene.Node;

/**
 * Ties the viewer to the bound Viewpoint (X3D 4.0, 23.3.1): binding one takes the viewer there;
 * when it moves, by animation or through the SAI, the viewer moves with it and keeps the offset
 * that the user walked.
 */
final class ViewpointFollower {
  private final InstanceTree instances;
  private final BindStacks bindables;
  private final Viewer viewer;
  private @Nullable Node followed;
  private final Matrix4d pose = new Matrix4d();
  private boolean started;

  ViewpointFollower(InstanceTree instances, BindStacks bindables, Viewer viewer) {
    this.instances = instances;
    this.bindables = bindables;
    this.viewer = viewer;
    follow();
  }

  /** Takes the viewer to the bound viewpoint, whatever the user walked. */
  void jump() {
    started = false;
    follow();
  }

  /** Once per frame, before the user's own motion. */
  void follow() {
    Optional<Node> bound = bindables.bound("X3DViewpointNode");
    Node viewpoint = bound.orElse(null);
    Matrix4d now = bound.map(this::poseOf).orElseGet(() -> new Matrix4d().translation(0, 0, 10));
    if (!started || viewpoint != followed && (viewpoint == null || viewpoint.bool("jump"))) {
      place(now);
      bound
          .filter(node -> node.type().name().equals("Viewpoint"))
          .ifPresent(node -> viewer.fieldOfView(node.number("fieldOfView")));
    } else if (viewpoint == followed && !now.equals(pose)) {
      place(now.mul(pose.invertAffine(new Matrix4d()).mul(viewerPose()), new Matrix4d()));
      if (viewpoint != null && viewpoint.type().name().equals("Viewpoint")) {
        viewer.fieldOfView(viewpoint.number("fieldOfView"));
      }
    }
    started = true;
    followed = viewpoint;
    pose.set(now);
  }

  private Matrix4d viewerPose() {
    return new Matrix4d().translationRotate(viewer.position(), viewer.orientation());
  }

  private void place(Matrix4dc to) {
    viewer.moveTo(to.getTranslation(new Vector3d()));
    viewer.turnTo(to.getUnnormalizedRotation(new Quaterniond()));
  }

  /** Where a viewpoint looks from: a rigid transformation, the scale above it left out. */
  Matrix4d poseOf(Node viewpoint) {
    float[] p = viewpoint.floats("position");
    float[] o = viewpoint.floats("orientation");
    Matrix4d place = placeOf(viewpoint);
    Vector3d eye = place.transformPosition(new Vector3d(p[0], p[1], p[2]));
    Quaterniond turn = place.getNormalizedRotation(new Quaterniond());
    Vector3d axis = new Vector3d(o[0], o[1], o[2]);
    if (axis.lengthSquared() > 0) {
      axis.normalize();
      turn.rotateAxis(o[3], axis);
    }
    return new Matrix4d().translationRotate(eye, turn);
  }

  /** From a viewpoint's local coordinates to the world; the identity when it is nowhere. */
  Matrix4d placeOf(Node viewpoint) {
    List<Occurrence> places = instances.occurrences(viewpoint);
    return places.isEmpty() ? new Matrix4d() : new Matrix4d(places.get(0).world());
  }
}
