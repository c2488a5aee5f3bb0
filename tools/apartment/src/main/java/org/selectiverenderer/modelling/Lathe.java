package org.selectiverenderer.modelling;

import java.util.ArrayList;
import java.util.List;
import org.joml.Vector3d;
import org.selectiverenderer.geometry.DegreeMath;
import org.selectiverenderer.geometry.mesh.TriangleMesh;

/**
 * Builds surfaces of revolution about +y: a profile (x the radius, y the height) rotated in steps.
 */
public final class Lathe {

  private Lathe() {}

  /**
   * Returns a closed solid: an end of the profile that is off the axis is closed by a disc. A pair
   * of neighbouring points gives {@code 2 * segments} triangles, {@code segments} if one is on the
   * axis; a disc gives {@code segments}.
   *
   * @param profile e.g. from the middle of the underside up the outer wall, over the rim, down the
   *     inner wall, to the middle of the bottom inside
   * @throws IllegalArgumentException if a radius is negative
   */
  public static TriangleMesh solid(ProfileCurve profile, int segments) {
    return LoftedSurface.over(rows(profile, segments, 360, segments), LoftedSurface.Form.CAPPED);
  }

  /**
   * Returns a surface as {@link #solid} does, but open where the profile ends; the profile must run
   * up the outside.
   */
  public static TriangleMesh surface(ProfileCurve profile, int segments) {
    return LoftedSurface.over(rows(profile, segments, 360, segments), LoftedSurface.Form.PIPE);
  }

  /**
   * Returns a ring: an outline beside the axis rotated about it, {@code 2 * size * segments}
   * triangles.
   *
   * @param section the outline, all of it at positive x
   */
  public static TriangleMesh ring(SimplePolygon section, int segments) {
    return LoftedSurface.over(
        rows(ProfileCurve.of(section.points()), segments, 360, segments), LoftedSurface.Form.RING);
  }

  /**
   * Returns an open surface over a part of a turn, from the +x axis counter-clockwise seen from
   * above.
   */
  public static TriangleMesh sector(ProfileCurve profile, double degrees, int segments) {
    return LoftedSurface.over(
        rows(profile, segments, degrees, segments + 1), LoftedSurface.Form.SHEET);
  }

  private static List<Vector3d[]> rows(
      ProfileCurve profile, int segments, double degrees, int columns) {
    List<Vector3d[]> rows = new ArrayList<>();
    for (int i = 0; i < profile.size(); i++) {
      double radius = profile.x(i);
      if (radius < -1e-9) {
        throw new IllegalArgumentException(
            "point " + i + " of a lathe's profile has a negative radius");
      }
      Vector3d[] row = new Vector3d[columns];
      for (int c = 0; c < columns; c++) {
        double angle = degrees * c / segments;
        row[c] =
            new Vector3d(
                radius * DegreeMath.cos(angle), profile.y(i), -radius * DegreeMath.sin(angle));
      }
      rows.add(row);
    }
    return rows;
  }
}
