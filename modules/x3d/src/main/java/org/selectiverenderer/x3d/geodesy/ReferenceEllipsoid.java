package org.selectiverenderer.x3d.geodesy;

import java.util.Optional;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/** The reference ellipsoids of X3D 4.0, Table 25.3, named by their codes. */
enum ReferenceEllipsoid {
  AA(6377563.396, 299.3249646),
  AM(6377340.189, 299.3249646),
  AN(6378160, 298.25),
  BN(6377483.865, 299.1528128),
  BR(6377397.155, 299.1528128),
  CC(6378206.4, 294.9786982),
  CD(6378249.145, 293.465),
  EA(6377276.345, 300.8017),
  EB(6377298.556, 300.8017),
  EC(6377301.243, 300.8017),
  ED(6377295.664, 300.8017),
  EE(6377304.063, 300.8017),
  EF(6377309.613, 300.8017),
  FA(6378155, 298.3),
  HE(6378200, 298.3),
  HO(6378270, 297),
  ID(6378160, 298.247),
  IN(6378388, 297),
  KA(6378245, 298.3),
  RF(6378137, 298.257222101),
  SA(6378160, 298.25),
  WD(6378135, 298.26),
  WE(6378137, 298.257223563);

  private static final int STEPS = 8;

  private final double semiMajor;
  private final double flattening;

  ReferenceEllipsoid(double semiMajor, double inverseFlattening) {
    this.semiMajor = semiMajor;
    this.flattening = 1 / inverseFlattening;
  }

  static Optional<ReferenceEllipsoid> of(String code) {
    for (ReferenceEllipsoid each : values()) {
      if (each.name().equals(code)) {
        return Optional.of(each);
      }
    }
    return Optional.empty();
  }

  /** Returns the semi-major axis in metres. */
  double semiMajor() {
    return semiMajor;
  }

  double flattening() {
    return flattening;
  }

  private double eccentricitySquared() {
    return flattening * (2 - flattening);
  }

  /**
   * Converts geodetic to geocentric coordinates in metres (EPSG method 9602).
   *
   * @param latitude radians, north positive
   * @param longitude radians, east positive
   * @param height metres above the ellipsoid
   */
  Vector3d geocentric(double latitude, double longitude, double height) {
    double e2 = eccentricitySquared();
    double sin = Math.sin(latitude);
    double radius = semiMajor / Math.sqrt(1 - e2 * sin * sin);
    double across = (radius + height) * Math.cos(latitude);
    return new Vector3d(
        across * Math.cos(longitude),
        across * Math.sin(longitude),
        (radius * (1 - e2) + height) * sin);
  }

  /**
   * Converts geocentric coordinates in metres to latitude and longitude in radians and height in
   * metres, with an error below a millimetre from deep below the surface to far above it.
   */
  Vector3d geodetic(Vector3dc at) {
    double e2 = eccentricitySquared();
    double across = Math.hypot(at.x(), at.y());
    if (across < 1e-9 && Math.abs(at.z()) < 1e-9) {
      return new Vector3d(0, 0, -semiMajor);
    }
    // Bowring's iteration of the reduced latitude, until it converges
    double minor = semiMajor * (1 - flattening);
    double reduced = Math.atan2(at.z(), (1 - flattening) * across);
    double latitude = 0;
    for (int step = 0; step < STEPS; step++) {
      double sin = Math.sin(reduced);
      double cos = Math.cos(reduced);
      latitude =
          Math.atan2(
              at.z() + e2 / (1 - e2) * minor * sin * sin * sin,
              across - e2 * semiMajor * cos * cos * cos);
      reduced = Math.atan2((1 - flattening) * Math.sin(latitude), Math.cos(latitude));
    }
    double sin = Math.sin(latitude);
    double height =
        across * Math.cos(latitude) + at.z() * sin - semiMajor * Math.sqrt(1 - e2 * sin * sin);
    return new Vector3d(latitude, Math.atan2(at.y(), at.x()), height);
  }
}
