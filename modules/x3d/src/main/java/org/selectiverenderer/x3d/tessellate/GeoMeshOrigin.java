package org.selectiverenderer.x3d.tessellate;

import java.util.Optional;
import org.joml.Vector3d;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.geodesy.GeoCoordinateTransform;

/**
 * Chooses the local origin of a geospatial geometry's mesh (relative-to-center rendering). Floats
 * resolve geocentric coordinates only to half a metre, so the mesh stores offsets from a point near
 * it, which is added in double precision when the mesh is placed.
 */
public final class GeoMeshOrigin {
  /** The distance from the scene's origin up to which floats are precise enough. */
  private static final double NEAR = 4096;

  private GeoMeshOrigin() {}

  /**
   * Returns the local origin of a geometry node's mesh, in scene coordinates; empty for nodes
   * without geospatial coordinates and for those near the scene's origin.
   */
  public static Optional<Vector3d> of(NodeView geometry) {
    if (geometry.type().name().equals("GeoElevationGrid")) {
      double[] at = (double[]) geometry.value("geoGridOrigin");
      return far(GeoCoordinateTransform.of(geometry).scene(at[0], at[1], at[2]));
    }
    if (geometry.type().field("coord").isEmpty()) {
      return Optional.empty();
    }
    NodeView coord = geometry.node("coord");
    if (coord == null || !coord.type().name().equals("GeoCoordinate")) {
      return Optional.empty();
    }
    double[] points = (double[]) coord.value("point");
    return points.length < 3
        ? Optional.empty()
        : far(GeoCoordinateTransform.of(coord).scene(points[0], points[1], points[2]));
  }

  private static Optional<Vector3d> far(Vector3d at) {
    return at.length() > NEAR && at.isFinite()
        ? Optional.of(at.set(Math.rint(at.x), Math.rint(at.y), Math.rint(at.z)))
        : Optional.empty();
  }
}
