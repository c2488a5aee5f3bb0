package org.selectiverenderer.x3d.geodesy;

import org.joml.Matrix3d;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.x3d.catalogue.NodeView;

/**
 * Converts between a geospatial node's coordinates and scene coordinates, by its {@code geoSystem}
 * and its {@code geoOrigin}, if any (X3D 4.0, 25.2.5 and 25.3.5). Without an origin, scene
 * coordinates are geocentric; with one they are metres relative to it, with {@code rotateYUp}
 * rotated so that up is +Y and north is -Z there.
 */
public final class GeoCoordinateTransform {
  private final SpatialReferenceSystem system;
  private final Vector3d origin = new Vector3d();
  private final Matrix3d turn = new Matrix3d();

  private GeoCoordinateTransform(SpatialReferenceSystem system) {
    this.system = system;
  }

  /**
   * Returns the frame of a node.
   *
   * @param node a node with the fields {@code geoSystem} and {@code geoOrigin}
   */
  public static GeoCoordinateTransform of(NodeView node) {
    GeoCoordinateTransform frame =
        new GeoCoordinateTransform(SpatialReferenceSystem.of(node.strings("geoSystem")));
    NodeView origin = node.node("geoOrigin");
    if (origin != null && origin.type().name().equals("GeoOrigin")) {
      SpatialReferenceSystem own = SpatialReferenceSystem.of(origin.strings("geoSystem"));
      double[] at = (double[]) origin.value("geoCoords");
      frame.origin.set(own.geocentric(at[0], at[1], at[2]));
      if (origin.bool("rotateYUp")) {
        frame.turn.set(axes(own.geodetic(frame.origin))).transpose();
      }
    }
    return frame;
  }

  /** Returns the local axes x, y, z of a place on the earth: east, up and south as columns. */
  private static Matrix3d axes(Vector3dc geodetic) {
    double sinLat = Math.sin(geodetic.x());
    double cosLat = Math.cos(geodetic.x());
    double sinLon = Math.sin(geodetic.y());
    double cosLon = Math.cos(geodetic.y());
    return new Matrix3d(
        -sinLon,
        cosLon,
        0,
        cosLat * cosLon,
        cosLat * sinLon,
        sinLat,
        sinLat * cosLon,
        sinLat * sinLon,
        -cosLat);
  }

  /** Returns the spatial reference system of the node's coordinates. */
  public SpatialReferenceSystem system() {
    return system;
  }

  /** Converts a coordinate of the node to scene coordinates in metres. */
  public Vector3d scene(double a, double b, double c) {
    return turn.transform(system.geocentric(a, b, c).sub(origin));
  }

  /** Converts a point of the scene to a coordinate of the node. */
  public double[] coordinates(Vector3dc scene) {
    return system.coordinates(turn.transformTranspose(scene, new Vector3d()).add(origin));
  }

  /**
   * Returns the transform to the scene from the local frame of a place, in metres with x east, y
   * up, z south (X3D 4.0, 25.3.7).
   *
   * @param at the place, a coordinate of the node
   */
  public Matrix4d place(double[] at) {
    Vector3d geocentric = system.geocentric(at[0], at[1], at[2]);
    Matrix3d axes = turn.mul(axes(system.geodetic(geocentric)), new Matrix3d());
    return new Matrix4d(axes).setTranslation(turn.transform(geocentric.sub(origin)));
  }
}
