package org.selectiverenderer.browser.nodes.bindable;

import java.util.Optional;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.scene.Rotations;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * Viewpoint and OrthoViewpoint (X3D 4.0, 23.4.6, 23.4.5): a pose of the viewer, in the node's local
 * coordinates. The NavigationInfo in its field {@code navigationInfo} is bound and unbound with it.
 */
public class ViewpointNode extends BindableNode {
  /** The default of Viewpoint's {@code fieldOfView}. */
  private static final double DEFAULT_FIELD_OF_VIEW = Math.PI / 4;

  private static final Matrix4dc IDENTITY = new Matrix4d();

  private final int navigationInfo;
  private final int fieldOfView;

  public ViewpointNode(NodeType type, @Nullable String name, SourceLocation location) {
    super(type, name, location);
    navigationInfo = type.indexOf("navigationInfo");
    fieldOfView = type.indexOf("fieldOfView");
  }

  /**
   * Returns the matrix from the coordinates of the node's fields, +Y up, to those of its group; the
   * identity except for a GeoViewpoint.
   */
  public Matrix4dc frame() {
    return IDENTITY;
  }

  /** Returns the point that EXAMINE turns about, in the coordinates of {@link #frame()}, if any. */
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

  /** Returns the rotation from the viewer's frame, looking along -Z, to the local coordinates. */
  public Quaterniond orientation() {
    return Rotations.read(floats("orientation"), 0, new Quaterniond());
  }

  /**
   * Returns the smaller viewing angle in radians; for an OrthoViewpoint, which has none, the
   * default of Viewpoint.
   */
  public double fieldOfView() {
    return value(fieldOfView) instanceof Float angle ? angle : DEFAULT_FIELD_OF_VIEW;
  }

  /**
   * Returns the {@code fieldOfView} of an OrthoViewpoint in local units: left, bottom, right, top.
   * Empty for a Viewpoint.
   */
  public Optional<float[]> extent() {
    return value(fieldOfView) instanceof float[] numbers ? Optional.of(numbers) : Optional.empty();
  }

  /** Returns whether binding the viewpoint moves the viewer there. */
  public boolean jump() {
    return bool("jump");
  }

  /** Returns whether the viewpoint shows the whole scene (X3D 4.0, 23.3.5). */
  public boolean viewAll() {
    return bool("viewAll");
  }

  /**
   * Returns whether this shows the whole scene and has no description, as the viewpoint that a
   * model of another program without a camera is given. In an Inline it is offered to nobody: it
   * would show the scene around the model.
   */
  boolean isUnnamedOverview() {
    return viewAll() && "".equals(value("description"));
  }

  Optional<BindableNode> navigationInfo() {
    return value(navigationInfo) instanceof BindableNode info
        ? Optional.of(info)
        : Optional.empty();
  }

  @Override
  void sendBound(boolean bound, EventCascade cascade) {
    super.sendBound(bound, cascade);
    navigationInfo().ifPresent(info -> cascade.send(info, info.setBind(), bound));
  }
}
