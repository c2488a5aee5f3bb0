package org.selectiverenderer.browser;

import java.util.List;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.instance.GroupInstance;
import org.selectiverenderer.browser.instance.Instance;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.browser.scene.Node;

/** Evaluates the ViewpointGroups above a viewpoint (X3D 4.0, 23.4.7). */
final class ViewpointGroups {
  private final InstanceTree instances;

  ViewpointGroups(InstanceTree instances) {
    this.instances = instances;
  }

  /**
   * Returns whether a viewpoint is offered to the user: no group above it is hidden, and the viewer
   * is inside the box of each group that has one. Of several instances of a viewpoint the first
   * counts.
   */
  boolean offers(Node viewpoint, Vector3dc eye) {
    for (GroupInstance group = above(viewpoint); group != null; group = group.parent()) {
      if (isGroup(group) && !(group.node().bool("displayed") && inBox(group, eye))) {
        return false;
      }
    }
    return true;
  }

  /** Returns whether a group above the viewpoint has {@code retainUserOffsets}. */
  boolean retainsOffsets(Node viewpoint) {
    for (GroupInstance group = above(viewpoint); group != null; group = group.parent()) {
      if (isGroup(group) && group.node().bool("retainUserOffsets")) {
        return true;
      }
    }
    return false;
  }

  private @Nullable GroupInstance above(Node viewpoint) {
    List<Instance> places = instances.instances(viewpoint);
    return places.isEmpty() ? null : places.get(0).parent();
  }

  private static boolean isGroup(GroupInstance group) {
    return group.node().type().name().equals("ViewpointGroup");
  }

  /** Returns whether the viewer is inside the box of a group; a size of 0 means no box. */
  private static boolean inBox(GroupInstance group, Vector3dc eye) {
    float[] size = group.node().floats("size");
    if (size[0] == 0 && size[1] == 0 && size[2] == 0) {
      return true;
    }
    float[] center = group.node().floats("center");
    Vector3d at = group.world().invert(new Matrix4d()).transformPosition(eye, new Vector3d());
    return Math.abs(at.x - center[0]) <= size[0] / 2
        && Math.abs(at.y - center[1]) <= size[1] / 2
        && Math.abs(at.z - center[2]) <= size[2] / 2;
  }
}
