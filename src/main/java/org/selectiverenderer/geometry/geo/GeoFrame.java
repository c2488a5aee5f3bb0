package org.selectiverenderer.geometry.geo;

import org.joml.Matrix3d;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.x3d.catalogue.NodeView;

/**
 * How a geospatial node's coordinates lie in the scene: its {@code geoSystem}, and its {@code
 * geoOrigin} if it has one (X3D 4.0, 25.2.5 and 25.3.5). Without an origin scene coordinates are
 * geocentric; with one they are metres from it, and with {@code rotateYUp} turned so that up is +Y
 * and north is -Z there.
 */
public final class GeoFrame {
  private final GeoSystem system;
  private final Vector3d origin = new Vector3d();
  private final Matrix3d turn = new Matrix3d();

  private GeoFrame(GeoSystem system) {
    this.system = system;
  }

  /**
   * @param node with the fields {@code geoSystem} and {@code geoOrigin}
   */
  public static GeoFrame of(NodeView node) {
    GeoFrame frame = new GeoFrame(GeoSystem.of(node.strings("geoSystem")));
    NodeView origin = node.node("geoOrigin");
    if (origin != null && origin.type().name().equals("GeoOrigin")) {
      GeoSystem own = GeoSystem.of(origin.strings("geoSystem"));
      double[] at = (double[]) origin.value("geoCoords");
      frame.origin.set(own.geocentric(at[0], at[1], at[2]));
      if (origin.bool("rotateYUp")) {
        frame.turn.set(axes(own.geodetic(frame.origin))).transpose();
      }
    }
    return frame;
  }

  /** East, up and south as columns: the axes x, y, z of a place on the earth. */
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

  /** The system that its coordinates are in. */
  public GeoSystem system() {
    return system;
  }

  /** From three numbers of the node to the scene, metres. */
  public Vector3d scene(double a, double b, double c) {
    return turn.transform(system.geocentric(a, b, c).sub(origin));
  }

  /** From a point of the scene to three numbers of the node. */
  public double[] coordinates(Vector3dc scene) {
    return system.coordinates(turn.transformTranspose(scene, new Vector3d()).add(origin));
  }

  /**
   * From coordinates about a place, x east, y up, z south, metres, to the scene (X3D 4.0, 25.3.7).
   *
   * @param at three numbers of the node
   */
  public Matrix4d place(double[] at) {
    Vector3d geocentric = system.geocentric(at[0], at[1], at[2]);
    Matrix3d axes = turn.mul(axes(system.geodetic(geocentric)), new Matrix3d());
    return new Matrix4d(axes).setTranslation(turn.transform(geocentric.sub(origin)));
  }
}
