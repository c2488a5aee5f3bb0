package org.selectiverenderer.browser;

import java.util.List;
import java.util.Optional;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.browser.instance.VisibleBoundsCalculator;
import org.selectiverenderer.browser.nodes.bindable.BindingStacks;
import org.selectiverenderer.browser.nodes.bindable.ViewpointNode;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.viewer.CameraFraming;
import org.selectiverenderer.browser.viewer.OrthographicExtent;
import org.selectiverenderer.browser.viewer.Pose;
import org.selectiverenderer.browser.viewer.Viewer;
import org.selectiverenderer.browser.viewer.ViewpointFrame;
import org.selectiverenderer.geometry.BoundingBox;

/**
 * Keeps the viewer at the bound Viewpoint (X3D 4.0, 23.3.1). Binding a viewpoint moves the viewer
 * there unless its {@code jump} is FALSE. When the bound viewpoint moves, by animation or through
 * the SAI, the viewer moves with it and keeps the offset by which the user has navigated away from
 * it. With {@code retainUserOffsets} the viewer keeps that offset when the viewpoint is bound.
 */
final class ViewpointFollower {
  /** The viewer's pose in a scene without viewpoints: the defaults of Viewpoint. */
  private static final Matrix4dc DEFAULT = new Matrix4d().translation(0, 0, 10);

  private final InstanceTree instances;
  private final BindingStacks bindables;
  private final ViewpointGroups groups;
  private Viewer viewer;
  private @Nullable Node followed;
  private final Matrix4d pose = new Matrix4d();
  private boolean started;
  private int jumps;
  private boolean viewsAll;

  /** Whether the viewer is to be moved to see the whole scene as soon as a shape is shown. */
  private boolean allWanted;

  private @Nullable Vector3d centre;
  private @Nullable OrthographicExtent wide;

  ViewpointFollower(InstanceTree instances, BindingStacks bindables, Viewer viewer) {
    this.instances = instances;
    this.bindables = bindables;
    this.viewer = viewer;
    groups = new ViewpointGroups(instances);
    follow();
  }

  /** Moves another viewer from now on, which takes the pose of the one before. */
  void lead(Viewer other) {
    viewer = other;
  }

  /** Moves the viewer to the bound viewpoint and drops the user's offset. */
  void jump() {
    started = false;
    follow();
  }

  /** Returns how often binding a viewpoint has moved the viewer. */
  int jumps() {
    return jumps;
  }

  /** Updates the viewer; called once per frame, before the user's own motion. */
  void follow() {
    Optional<ViewpointNode> bound =
        bindables
            .bound("X3DViewpointNode")
            .filter(ViewpointNode.class::isInstance)
            .map(ViewpointNode.class::cast);
    ViewpointNode viewpoint = bound.orElse(null);
    boolean another = !started || viewpoint != followed;
    boolean first = !started;
    if (viewpoint == null) {
      // The viewer stays where the last viewpoint left it (X3D 4.0, 7.2.2: none is bound).
      if (!started) {
        place(DEFAULT);
        endView();
        viewer.fieldOfView(Math.PI / 4);
        viewer.extent(Optional.empty());
        pose.set(DEFAULT);
      }
    } else {
      Matrix4d now = poseOf(viewpoint);
      if (!started) {
        endView();
        place(now);
      } else if (another && viewpoint.jump()) {
        jumps++;
        endView();
        place(retainsOffset(viewpoint) ? keepingOffset(now) : now);
      } else if (!another && !now.equals(pose)) {
        place(keepingOffset(now));
      }
      // Without a jump the viewer stays and sees as before, until it is moved.
      if (!another || !started || viewpoint.jump()) {
        viewer.fieldOfView(viewpoint.fieldOfView());
        double scale = ViewpointFrame.of(placeOf(viewpoint)).scale();
        viewer.extent(
            viewpoint
                .extent()
                .map(extent -> wide == null ? OrthographicExtent.of(extent).times(scale) : wide));
      }
      pose.set(now);
    }
    started = true;
    followed = viewpoint;
    followAll(viewpoint, first, another);
  }

  /** Shows the whole scene when a viewpoint with {@code viewAll} is bound or the field is set. */
  private void followAll(@Nullable ViewpointNode viewpoint, boolean first, boolean another) {
    boolean before = viewsAll && !another;
    viewsAll = viewpoint != null && viewpoint.viewAll();
    if (viewpoint != null && viewsAll && !before && (first || !another || viewpoint.jump())) {
      if (!another) {
        jumps++;
      }
      allWanted = true;
    }
    if (allWanted) {
      allWanted = !viewAll();
    }
  }

  /**
   * Moves the viewer to where the whole scene is in view; binding another viewpoint ends that.
   *
   * @return whether the scene shows any shape
   */
  boolean viewAll() {
    Optional<BoundingBox> all = VisibleBoundsCalculator.of(instances.shapes());
    all.ifPresent(this::look);
    return all.isPresent();
  }

  /** Moves the viewer to where a whole bounding box is in view. */
  void look(BoundingBox box) {
    Node from = followed;
    ViewpointFrame frame = from == null ? ViewpointFrame.WORLD : ViewpointFrame.of(placeOf(from));
    CameraFraming framing = CameraFraming.of(box, Pose.of(viewer), frame.upright());
    boolean parallel = viewer.extent().isPresent();
    framing.pose().applyTo(viewer);
    wide = framing.extent();
    viewer.extent(parallel ? Optional.of(framing.extent()) : Optional.empty());
    centre = framing.centre();
  }

  /**
   * Returns the point that EXAMINE turns about: the centre of the last framed box, or else the
   * bound viewpoint's {@code centerOfRotation}.
   */
  Optional<Vector3dc> pivot() {
    return centre()
        .or(
            () ->
                followed instanceof ViewpointNode known
                    ? known
                        .centerOfRotation()
                        .map(at -> (Vector3dc) placeOf(known).transformPosition(at))
                    : Optional.empty());
  }

  private void endView() {
    allWanted = false;
    centre = null;
    wide = null;
  }

  /** Returns the centre of the box that was last framed; empty at a viewpoint of the scene. */
  Optional<Vector3dc> centre() {
    return Optional.ofNullable(centre);
  }

  private boolean retainsOffset(ViewpointNode viewpoint) {
    return viewpoint.bool("retainUserOffsets") || groups.retainsOffsets(viewpoint);
  }

  /** Returns the viewer's pose with the same offset from the viewpoint's new pose. */
  private Matrix4d keepingOffset(Matrix4dc now) {
    Matrix4d viewerPose = new Matrix4d().translationRotate(viewer.position(), viewer.orientation());
    return now.mul(pose.invertAffine(new Matrix4d()).mul(viewerPose), new Matrix4d());
  }

  private void place(Matrix4dc to) {
    viewer.moveTo(to.getTranslation(new Vector3d()));
    viewer.turnTo(to.getUnnormalizedRotation(new Quaterniond()));
  }

  /** Returns whether the ViewpointGroups above a viewpoint offer it to the user now. */
  boolean offers(Node viewpoint) {
    return groups.offers(viewpoint, viewer.position());
  }

  /**
   * Returns a viewpoint's pose in the world: a rigid transformation without the scale of the groups
   * above.
   */
  Matrix4d poseOf(ViewpointNode viewpoint) {
    Matrix4dc place = placeOf(viewpoint);
    Vector3d eye = place.transformPosition(viewpoint.position());
    Quaterniond turn = new Quaterniond(ViewpointFrame.of(place).upright());
    return new Matrix4d().translationRotate(eye, turn.mul(viewpoint.orientation()));
  }

  /**
   * Returns the matrix from a viewpoint's local coordinates to the world; the identity if the
   * viewpoint is in no part of the scene.
   */
  Matrix4dc placeOf(Node viewpoint) {
    List<Matrix4dc> places = instances.places(viewpoint);
    Matrix4dc place = places.isEmpty() ? new Matrix4d() : places.get(0);
    return viewpoint instanceof ViewpointNode looking
        ? place.mul(looking.frame(), new Matrix4d())
        : place;
  }
}
