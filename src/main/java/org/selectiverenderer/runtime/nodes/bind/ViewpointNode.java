package org.selectiverenderer.runtime.nodes.bind;

import java.util.Optional;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.runtime.scene.Cascade;
import org.selectiverenderer.runtime.scene.Rotations;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * Viewpoint and OrthoViewpoint (X3D 4.0, 23.4.6, 23.4.5): a place to look from, in the node's local
 * coordinates. The NavigationInfo in it is bound and unbound with it.
 */
public class ViewpointNode extends BindableNode {
  /** The default of Viewpoint's {@code fieldOfView}. */
  private static final double DEFAULT_FIELD_OF_VIEW = Math.PI / 4;

  private static final Matrix4dc IDENTITY = new Matrix4d();

  private final int navigationInfo;
  private final int fieldOfView;

  public ViewpointNode(NodeType type, @Nullable String name, Location location) {
    super(type, name, location);
    navigationInfo = type.indexOf("navigationInfo");
    fieldOfView = type.indexOf("fieldOfView");
  }

  /**
   * From the coordinates in which it stands, +Y up, to those of the group that it is in; the same
   * but for a GeoViewpoint.
   */
  public Matrix4dc frame() {
    return IDENTITY;
  }

  /** The point that the viewer turns about, in the coordinates of {@link #frame()}, if any. */
  public Optional<Vector3d> centerOfRotation() {
    if (!type().name().equals("Viewpoint")) {
      return Optional.empty();
    }
    float[] c = floats("centerOfRotation");
    return Optional.of(new Vector3d(c[0], c[1], c[2]));
  }

  public Vector3d position() {
    float[] p = floats("position");
    return new Vector3d(p[0], p[1], p[2]);
  }

  /** Takes the viewer's frame, looking along -Z, to the local coordinates. */
  public Quaterniond orientation() {
    return Rotations.read(floats("orientation"), 0, new Quaterniond());
  }

  /** The smaller viewing angle in radians; the default for an OrthoViewpoint, which has none. */
  public double fieldOfView() {
    return value(fieldOfView) instanceof Float angle ? angle : DEFAULT_FIELD_OF_VIEW;
  }

  /**
   * What an OrthoViewpoint shows, in its own unit: left, bottom, right, top as its field has them.
   * Empty for a Viewpoint.
   */
  public Optional<float[]> extent() {
    return value(fieldOfView) instanceof float[] numbers ? Optional.of(numbers) : Optional.empty();
  }

  /** Whether binding it takes the viewer there. */
  public boolean jump() {
    return bool("jump");
  }

  /** Whether all of the scene is to be seen from it (X3D 4.0, 23.3.5). */
  public boolean viewAll() {
    return bool("viewAll");
  }

  Optional<BindableNode> navigationInfo() {
    return value(navigationInfo) instanceof BindableNode info
        ? Optional.of(info)
        : Optional.empty();
  }

  @Override
  void sendBound(boolean bound, Cascade cascade) {
    super.sendBound(bound, cascade);
    navigationInfo().ifPresent(info -> cascade.send(info, info.setBind(), bound));
  }
}
