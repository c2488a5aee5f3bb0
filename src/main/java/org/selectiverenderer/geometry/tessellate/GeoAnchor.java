package org.selectiverenderer.geometry.tessellate;

import java.util.Optional;
import org.joml.Vector3d;
import org.selectiverenderer.geometry.geo.GeoFrame;
import org.selectiverenderer.x3d.catalogue.NodeView;

/**
 * The point about which the mesh of a geospatial geometry is kept. A float tells places on the
 * earth's surface half a metre apart; so such a mesh holds the differences from a point near it,
 * and whoever places the mesh adds the point in double precision.
 */
public final class GeoAnchor {
  /** Distances from the scene's origin up to which floats are fine. */
  private static final double NEAR = 4096;

  private GeoAnchor() {}

  /**
   * What is to be added to the mesh of a geometry node, in the geometry's coordinates; nothing for
   * nodes without geospatial coordinates and for those near the origin.
   */
  public static Optional<Vector3d> of(NodeView geometry) {
    if (geometry.type().name().equals("GeoElevationGrid")) {
      double[] at = (double[]) geometry.value("geoGridOrigin");
      return far(GeoFrame.of(geometry).scene(at[0], at[1], at[2]));
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
        : far(GeoFrame.of(coord).scene(points[0], points[1], points[2]));
  }

  private static Optional<Vector3d> far(Vector3d at) {
    return at.length() > NEAR && at.isFinite()
        ? Optional.of(at.set(Math.rint(at.x), Math.rint(at.y), Math.rint(at.z)))
        : Optional.empty();
  }
}
