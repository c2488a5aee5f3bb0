package org.selectiverenderer.browser.nodes.geospatial;

import java.util.Optional;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.nodes.bindable.ViewpointNode;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.geodesy.GeoCoordinateTransform;

/**
 * GeoViewpoint (X3D 4.0, 25.3.12): a viewpoint whose orientation is relative to the local axes
 * east, up and south at its geographic position; with the default orientation it looks north.
 */
final class GeoViewpointNode extends ViewpointNode {
  private final int position;
  private final int centerOfRotation;

  GeoViewpointNode(NodeType type, @Nullable String name, SourceLocation location) {
    super(type, name, location);
    position = type.indexOf("position");
    centerOfRotation = type.indexOf("centerOfRotation");
  }

  @Override
  public Matrix4dc frame() {
    return GeoCoordinateTransform.of(this).place((double[]) value(position));
  }

  @Override
  public Vector3d position() {
    return new Vector3d();
  }

  @Override
  public Optional<Vector3d> centerOfRotation() {
    double[] c = (double[]) value(centerOfRotation);
    Vector3d scene = GeoCoordinateTransform.of(this).scene(c[0], c[1], c[2]);
    return Optional.of(frame().invertAffine(new Matrix4d()).transformPosition(scene));
  }
}
