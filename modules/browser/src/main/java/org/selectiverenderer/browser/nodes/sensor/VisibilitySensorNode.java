package org.selectiverenderer.browser.nodes.sensor;

import java.util.List;
import org.joml.FrustumIntersection;
import org.joml.Matrix4dc;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * VisibilitySensor: detects a box entering and leaving the view frustum (X3D 4.0, 22.4.3). The
 * corners of the transformed box are tested against each frustum plane; a box beside an edge of the
 * frustum may wrongly count as visible, as the standard allows. Occlusion is not considered.
 */
public final class VisibilitySensorNode extends EnvironmentalSensorNode {
  private static final int PLANES = 6;

  private final Vector3d[] corners = new Vector3d[8];

  public VisibilitySensorNode(NodeType type, @Nullable String name, SourceLocation location) {
    super(type, name, location);
    for (int i = 0; i < corners.length; i++) {
      corners[i] = new Vector3d();
    }
  }

  @Override
  public void frame(FrameContext frame, EventCascade cascade) {
    boolean visible = false;
    if (enabled() && hasExtent()) {
      List<? extends Matrix4dc> places = frame.places(this);
      for (int i = 0; i < places.size() && !visible; i++) {
        visible = sees(frame.frustum(), places.get(i));
      }
    }
    sense(visible, cascade);
  }

  /**
   * Returns whether the box has an extent: it may be flat, but not a point, and no size may be
   * negative.
   */
  private boolean hasExtent() {
    float[] s = size();
    return s[0] >= 0 && s[1] >= 0 && s[2] >= 0 && s[0] + s[1] + s[2] > 0;
  }

  private boolean sees(FrustumIntersection frustum, Matrix4dc place) {
    float[] c = center();
    float[] s = size();
    for (int i = 0; i < corners.length; i++) {
      double x = c[0] + ((i & 1) == 0 ? -0.5 : 0.5) * s[0];
      double y = c[1] + ((i & 2) == 0 ? -0.5 : 0.5) * s[1];
      double z = c[2] + ((i & 4) == 0 ? -0.5 : 0.5) * s[2];
      place.transformPosition(corners[i].set(x, y, z));
    }
    for (int plane = 0; plane < PLANES; plane++) {
      if (!anyInFrontOf(frustum, plane)) {
        return false;
      }
    }
    return true;
  }

  private boolean anyInFrontOf(FrustumIntersection frustum, int plane) {
    for (Vector3d corner : corners) {
      float x = (float) corner.x;
      float y = (float) corner.y;
      float z = (float) corner.z;
      if (frustum.distanceToPlane(x, y, z, x, y, z, plane) >= 0) {
        return true;
      }
    }
    return false;
  }
}
