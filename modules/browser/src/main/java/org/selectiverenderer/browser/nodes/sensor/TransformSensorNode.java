package org.selectiverenderer.browser.nodes.sensor;

import java.util.ArrayList;
import java.util.List;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.nodes.group.GroupingNode;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * TransformSensor: detects an object entering, moving in and leaving a box (X3D 4.0, 22.4.2). The
 * position of the object is the origin of its local coordinates, with its own transformation
 * applied.
 */
public final class TransformSensorNode extends EnvironmentalSensorNode {
  private final int targetObject;
  private final PoseEventSender pose;
  private final List<WorldToLocalTransform> locals = new ArrayList<>(1);
  private final Matrix4d target = new Matrix4d();
  private final Vector3d origin = new Vector3d();
  private final Vector3d local = new Vector3d();
  private final Vector3d forward = new Vector3d();
  private final Vector3d up = new Vector3d();

  public TransformSensorNode(NodeType type, @Nullable String name, SourceLocation location) {
    super(type, name, location);
    targetObject = type.indexOf("targetObject");
    pose = new PoseEventSender(this);
  }

  @Override
  public void frame(FrameContext frame, EventCascade cascade) {
    Node object = (Node) value(targetObject);
    WorldToLocalTransform found =
        object == null || !enabled() || !hasVolume() ? null : find(object, frame);
    boolean before = active();
    sense(found != null, cascade);
    if (found != null && enabled()) {
      target.transformDirection(forward.set(0, 0, -1));
      target.transformDirection(up.set(0, 1, 0));
      pose.send(found, local, forward, up, !before, cascade);
    }
  }

  /**
   * Returns the first instance of the box that contains an instance of the object, for the first
   * such instance of the object.
   */
  private @Nullable WorldToLocalTransform find(Node object, FrameContext frame) {
    List<? extends Matrix4dc> boxes = frame.places(this);
    List<? extends Matrix4dc> objects = frame.places(object);
    while (locals.size() < boxes.size()) {
      locals.add(new WorldToLocalTransform());
    }
    for (int o = 0; o < objects.size(); o++) {
      target.set(objects.get(o));
      if (object instanceof GroupingNode group) {
        group.placement().ifPresent(target::mul);
      }
      target.getTranslation(origin);
      for (int b = 0; b < boxes.size(); b++) {
        WorldToLocalTransform box = locals.get(b);
        if (box.follow(boxes.get(b)) && contains(box.point(origin, local))) {
          return box;
        }
      }
    }
    return null;
  }
}
