package org.selectiverenderer.browser.nodes.sensor;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.joml.Matrix4dc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.scene.Rotations;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * ProximitySensor: detects the viewer entering, moving in and leaving a box (X3D 4.0, 22.4.1; the
 * areas of the thesis). The eye is transformed to the box's local coordinates, so that the result
 * is exact under any transformation above the sensor; the boundary belongs to the box. A sensor
 * that is USEd senses the union of its boxes. It also works in a branch that a Switch hides.
 *
 * <p>The pose sent is relative to the instance that was entered, until the viewer leaves its box.
 * Events carry the frame's time: crossings between two frames are not interpolated.
 */
public class ProximitySensorNode extends EnvironmentalSensorNode {
  private final int centerOfRotationChanged;
  private final int positionChanged;
  private final PoseEventSender pose;
  private final List<WorldToLocalTransform> locals = new ArrayList<>(1);
  private final Vector3d eye = new Vector3d();
  private final Vector3d forward = new Vector3d();
  private final Vector3d up = new Vector3d();
  private int last;

  public ProximitySensorNode(NodeType type, @Nullable String name, SourceLocation location) {
    super(type, name, location);
    positionChanged = type.indexOf("position_changed");
    centerOfRotationChanged = type.indexOf("centerOfRotation_changed");
    pose = new PoseEventSender(this);
  }

  @Override
  public void frame(FrameContext frame, EventCascade cascade) {
    int at = enabled() && hasVolume() ? find(frame) : -1;
    boolean before = active();
    sense(at >= 0, cascade);
    if (at >= 0 && enabled()) { // A reaction to isActive may have disabled it.
      last = at;
      report(frame, locals.get(at), !before, cascade);
    }
  }

  /**
   * Returns the index of the instance whose box contains the eye, trying the last one first; -1 for
   * none.
   */
  private int find(FrameContext frame) {
    List<? extends Matrix4dc> places = frame.places(this);
    int count = places.size();
    while (locals.size() < count) {
      locals.add(new WorldToLocalTransform());
    }
    if (last < count && holds(places, last, frame.eye())) {
      return last;
    }
    for (int i = 0; i < count; i++) {
      if (holds(places, i, frame.eye())) {
        return i;
      }
    }
    return -1;
  }

  private boolean holds(List<? extends Matrix4dc> places, int place, Vector3dc worldEye) {
    WorldToLocalTransform local = locals.get(place);
    return local.follow(places.get(place)) && contains(local.point(worldEye, eye));
  }

  /**
   * Computes a world-space box that encloses all of the sensor's boxes with a margin for rounding:
   * a viewer outside it is in none of them.
   *
   * @param out min x, y, z, max x, y, z; infinite if a nearly singular transformation makes the
   *     rounding error unknown, and min above max if no box has a volume
   */
  public void reach(FrameContext frame, double[] out) {
    Arrays.fill(out, 0, 3, Double.POSITIVE_INFINITY);
    Arrays.fill(out, 3, 6, Double.NEGATIVE_INFINITY);
    if (hasVolume()) {
      float[] c = center();
      float[] s = size();
      for (Matrix4dc place : frame.places(this)) {
        WorldToLocalTransform.enclose(place, c, s, out);
      }
    }
  }

  /**
   * Hook for subclasses that send more about the viewer's position; called in each frame in which
   * the viewer is inside.
   *
   * @param moved whether {@code position_changed} has been sent
   */
  protected void reportPosition(Vector3dc local, boolean moved, EventCascade cascade) {}

  private void report(
      FrameContext frame, WorldToLocalTransform local, boolean always, EventCascade cascade) {
    Rotations.forward(frame.orientation(), forward);
    Rotations.up(frame.orientation(), up);
    float[] before = (float[]) value(positionChanged);
    pose.send(local, eye, forward, up, always, cascade);
    reportPosition(eye, value(positionChanged) != before, cascade);
    Vector3dc center = frame.centerOfRotation();
    if (center != null && enabled()) {
      pose.sendPoint(centerOfRotationChanged, local.point(center, eye), always, cascade);
    }
  }
}
