package org.selectiverenderer.render.lighting;

import org.joml.Matrix4dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.instance.SurfaceMaterial;

/**
 * The tolerance for curvature with per-vertex lighting: how finely a curved mesh must be refined so
 * that interpolation between vertices is not seen. Between two vertices whose normals differ by an
 * angle a, interpolated light has an error of up to a^2 / 8 of its strength, and a specular
 * highlight of exponent e an error of e times that.
 *
 * @param cosine the least cosine of the angle between the normals at an edge's ends
 * @param bent the size of triangles above which they are split because of their normals
 */
public record CurvatureTolerance(double cosine, double bent) {
  /**
   * The cosine of the angle between normals above which facets are visible even without a
   * highlight.
   */
  static final double WIDE = Math.cos(Math.toRadians(30));

  /** The cosine of the angle above which facets are visible in highlights. */
  static final double NARROW = Math.cos(Math.toRadians(20));

  /** Curved triangles of less than this size (in units of length) are small on every screen. */
  private static final double BENT = 0.05;

  /** The product of specular colour and shininess exponent above which a highlight is narrow. */
  private static final double NARROW_HIGHLIGHT = 16;

  /** The specular colour above which a highlight between two vertices is missed. */
  private static final double MIRROR = 0.3;

  /** The size of faces in whose middle such a highlight would be lost. */
  private static final double FACE = 0.5;

  /** The tolerance that every mesh meets. */
  static final CurvatureTolerance NONE = new CurvatureTolerance(-2, Double.POSITIVE_INFINITY);

  /** Returns the tolerance for a lit surface, in the world's units. */
  static CurvatureTolerance of(SurfaceMaterial surface) {
    boolean narrow = specular(surface) * 128 * surface.shininess() > NARROW_HIGHLIGHT;
    return new CurvatureTolerance(narrow ? NARROW : WIDE, BENT);
  }

  private static double specular(SurfaceMaterial surface) {
    float[] s = surface.specular();
    return Math.max(s[0], Math.max(s[1], s[2]));
  }

  /**
   * Returns whether a surface is so shiny, on faces so large, that per-vertex lighting would miss
   * highlights.
   */
  static boolean mirrors(SurfaceMaterial surface, MeshMetrics mesh, double scale) {
    return specular(surface) >= MIRROR && mesh.largest() * scale > FACE;
  }

  /**
   * Converts the tolerance to a mesh's own coordinates, whose lengths are {@code scale} times as
   * long in the world. Rounded down to a power of two, so that shapes of similar scales share a
   * refined mesh.
   */
  CurvatureTolerance local(double scale) {
    double length = bent / scale;
    return new CurvatureTolerance(
        cosine, Double.isFinite(length) ? Math.scalb(1.0, Math.getExponent(length)) : length);
  }

  /**
   * Returns whether a mesh is coarser than this tolerance allows.
   *
   * @param scale the scale from the mesh's lengths to the world's
   */
  boolean finerThan(MeshMetrics mesh, double scale) {
    return mesh.bent(cosine) * scale > bent;
  }

  /** Returns the largest scale of a matrix along the axes. */
  public static double scale(Matrix4dc world) {
    double x = Math.sqrt(sum(world.m00(), world.m01(), world.m02()));
    double y = Math.sqrt(sum(world.m10(), world.m11(), world.m12()));
    double z = Math.sqrt(sum(world.m20(), world.m21(), world.m22()));
    return Math.max(x, Math.max(y, z));
  }

  private static double sum(double x, double y, double z) {
    return x * x + y * y + z * z;
  }

  // Written out, as records link theirs when first called: the first frame would wait for it.
  @Override
  public boolean equals(@Nullable Object other) {
    return other instanceof CurvatureTolerance one
        && Double.compare(cosine, one.cosine) == 0
        && Double.compare(bent, one.bent) == 0;
  }

  @Override
  public int hashCode() {
    return 31 * Double.hashCode(cosine) + Double.hashCode(bent);
  }
}
