package org.selectiverenderer.x3d.geodesy;

import java.util.Optional;
import org.joml.Vector2d;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;

/**
 * The spatial reference system of a geospatial node's coordinates, given by its field {@code
 * geoSystem} (X3D 4.0, 25.2.3). GeoVRML's names {@code GDC} and {@code GCC} are accepted, too.
 */
public final class SpatialReferenceSystem {
  private enum Kind {
    GEODETIC,
    UTM,
    GEOCENTRIC
  }

  private final Kind kind;
  private final ReferenceEllipsoid ellipsoid;
  private final boolean secondFirst;
  private final @Nullable TransverseMercator projection;
  private final @Nullable String problem;

  private SpatialReferenceSystem(
      Kind kind,
      ReferenceEllipsoid ellipsoid,
      boolean secondFirst,
      @Nullable TransverseMercator projection,
      @Nullable String problem) {
    this.kind = kind;
    this.ellipsoid = ellipsoid;
    this.secondFirst = secondFirst;
    this.projection = projection;
    this.problem = problem;
  }

  /**
   * Parses the field.
   *
   * @param words the field's value; an empty one means geodetic coordinates on WGS 84
   */
  public static SpatialReferenceSystem of(String[] words) {
    Kind kind = Kind.GEODETIC;
    ReferenceEllipsoid ellipsoid = ReferenceEllipsoid.WE;
    int zone = 0;
    boolean southern = false;
    boolean secondFirst = false;
    String problem = null;
    for (String word : words) {
      Optional<ReferenceEllipsoid> named = ReferenceEllipsoid.of(word);
      if (named.isPresent()) {
        ellipsoid = named.get();
        continue;
      }
      switch (word) {
        case "GD", "GDC" -> kind = Kind.GEODETIC;
        case "GC", "GCC", "GS" -> kind = Kind.GEOCENTRIC;
        case "UTM" -> kind = Kind.UTM;
        case "S" -> southern = true;
        case "N", "latitude_first", "northing_first" -> {}
        case "longitude_first", "easting_first" -> secondFirst = true;
        case "WGS84" ->
            problem = "gives heights above the geoid; they are read as above the ellipsoid";
        default -> {
          if (word.matches("Z[0-9]{1,2}")) {
            zone = Integer.parseInt(word.substring(1));
          } else {
            problem = "has the unknown word \"" + word + "\" in its geoSystem; the word is ignored";
          }
        }
      }
    }
    if (kind == Kind.UTM && (zone < 1 || zone > 60)) {
      problem = "has a geoSystem without a UTM zone from Z1 to Z60; zone 1 is used";
      zone = 1;
    }
    return new SpatialReferenceSystem(
        kind,
        ellipsoid,
        secondFirst,
        kind == Kind.UTM ? new TransverseMercator(ellipsoid, zone, southern) : null,
        problem);
  }

  /** Returns an error in the field as the predicate of a sentence; the rest of it is used. */
  public Optional<String> problem() {
    return Optional.ofNullable(problem);
  }

  /** Converts a node's coordinate to geocentric metres. */
  public Vector3d geocentric(double a, double b, double c) {
    double first = secondFirst ? b : a;
    double second = secondFirst ? a : b;
    if (kind == Kind.GEOCENTRIC) {
      return new Vector3d(a, b, c);
    }
    if (projection != null) {
      Vector2d at = projection.geographic(second, first);
      return ellipsoid.geocentric(at.x, at.y, c);
    }
    return ellipsoid.geocentric(Math.toRadians(first), Math.toRadians(second), c);
  }

  /** Converts geocentric metres to a coordinate in this system. */
  public double[] coordinates(Vector3dc geocentric) {
    if (kind == Kind.GEOCENTRIC) {
      return new double[] {geocentric.x(), geocentric.y(), geocentric.z()};
    }
    Vector3d at = ellipsoid.geodetic(geocentric);
    double first = Math.toDegrees(at.x);
    double second = Math.toDegrees(at.y);
    if (projection != null) {
      Vector2d projected = projection.projected(at.x, at.y);
      first = projected.y;
      second = projected.x;
    }
    return secondFirst ? new double[] {second, first, at.z} : new double[] {first, second, at.z};
  }

  /**
   * Returns a coordinate displaced by an offset.
   *
   * @param at a coordinate in this system
   * @param east offset along longitude or easting, in the system's unit
   * @param north offset along latitude or northing, in the system's unit
   * @param up offset in metres
   */
  public double[] step(double[] at, double east, double north, double up) {
    boolean eastFirst = secondFirst || kind == Kind.GEOCENTRIC;
    return new double[] {
      at[0] + (eastFirst ? east : north), at[1] + (eastFirst ? north : east), at[2] + up
    };
  }

  /** Converts geocentric metres to latitude and longitude in radians and height in metres. */
  Vector3d geodetic(Vector3dc geocentric) {
    return ellipsoid.geodetic(geocentric);
  }
}
