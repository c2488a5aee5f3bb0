package org.selectiverenderer.runtime.render.light;

import org.joml.Matrix4dc;
import org.selectiverenderer.runtime.instance.Surface;

/**
 * How finely a mesh is to follow its own bends so that nobody sees that light is computed at its
 * vertices. Between two vertices whose normals lie an angle a apart the light departs from a
 * straight line by up to a a / 8 of its strength, and a highlight of exponent e by e times that.
 *
 * @param cosine least, of the angle between the normals of an edge's ends
 * @param bent size of triangles above which they are split for their normals
 */
public record Fineness(double cosine, double bent) {
  /** The cosine of an angle between normals that shows as facets even without a highlight. */
  static final double WIDE = Math.cos(Math.toRadians(30));

  /** That of one which shows only in highlights. */
  static final double NARROW = Math.cos(Math.toRadians(20));

  /** What is bent within five hundredths of a unit is small in every picture. */
  private static final double BENT = 0.05;

  /** The product of specular colour and exponent above which a highlight is narrow. */
  private static final double NARROW_HIGHLIGHT = 16;

  /** The specular colour from which on a highlight is missed where it falls between vertices. */
  private static final double MIRROR = 0.3;

  /** The size of a face in whose middle it would be. */
  private static final double FACE = 0.5;

  /** What every mesh has. */
  static final Fineness NONE = new Fineness(-2, Double.POSITIVE_INFINITY);

  /** What a lit surface needs, in the lengths of the world. */
  static Fineness of(Surface surface) {
    boolean narrow = specular(surface) * 128 * surface.shininess() > NARROW_HIGHLIGHT;
    return new Fineness(narrow ? NARROW : WIDE, BENT);
  }

  private static double specular(Surface surface) {
    float[] s = surface.specular();
    return Math.max(s[0], Math.max(s[1], s[2]));
  }

  /** Whether a surface shines so brightly on faces so large that its vertices miss highlights. */
  static boolean mirrors(Surface surface, MeshSurvey mesh, double scale) {
    return specular(surface) >= MIRROR && mesh.largest() * scale > FACE;
  }

  /**
   * The same for a mesh in its own coordinates, whose lengths are {@code scale} times as long in
   * the world. Rounded down to a power of two, so that meshes of many scales stay few.
   */
  Fineness local(double scale) {
    double length = bent / scale;
    return new Fineness(
        cosine, Double.isFinite(length) ? Math.scalb(1.0, Math.getExponent(length)) : length);
  }

  /**
   * Whether a mesh is coarser.
   *
   * @param scale of the world's lengths to the mesh's
   */
  boolean finerThan(MeshSurvey mesh, double scale) {
    return mesh.bent(cosine) * scale > bent;
  }

  /** How many times as long as in its own coordinates a length can be in the world. */
  public static double scale(Matrix4dc world) {
    double x = Math.sqrt(sum(world.m00(), world.m01(), world.m02()));
    double y = Math.sqrt(sum(world.m10(), world.m11(), world.m12()));
    double z = Math.sqrt(sum(world.m20(), world.m21(), world.m22()));
    return Math.max(x, Math.max(y, z));
  }

  private static double sum(double x, double y, double z) {
    return x * x + y * y + z * z;
  }
}
