package org.selectiverenderer.radiosity.texel;

import org.selectiverenderer.geometry.TriangleMath;
import org.selectiverenderer.radiosity.atlas.AtlasPage;
import org.selectiverenderer.radiosity.scene.Body;
import org.selectiverenderer.radiosity.scene.RadiosityScene;
import org.selectiverenderer.radiosity.solve.RadiositySolution;
import org.selectiverenderer.radiosity.trace.SceneTriangles;

/**
 * The surface point that a texel shows: position, normal, triangle and patch in world coordinates,
 * metres. Moves from texel to texel; one per thread.
 */
final class TexelSurfacePoint {
  /**
   * Share by which ray starts are moved from a triangle's edges towards its centroid, so that none
   * lies in a wall's plane.
   */
  private static final double EDGE = 1e-3;

  /** Upper limit of that move on triangles of many texels, as a share of a texel. */
  private static final double EDGE_TEXELS = 0.02;

  /**
   * Least cosine between the vertex normals and the triangle's own normal for which the surface is
   * shaded smooth.
   */
  private static final double ALIKE = 0.3;

  private final RadiosityScene scene;
  private final RadiositySolution solution;
  private final TexelIndex texels;
  private final SceneTriangles triangles;
  private final TexelFootprint own;
  private final TexelFootprint other;
  private final double[] corner = new double[9];
  private AtlasPage map;
  private int page = -1;
  private int local;
  private boolean flat;

  /** Position on the surface. */
  final double[] point = new double[3];

  /** Unit shading normal on the lit side. */
  final double[] normal = new double[3];

  /** Unit geometric normal of the triangle on the lit side. */
  final double[] facing = new double[3];

  int triangle;
  int patch;
  int version;

  TexelSurfacePoint(RadiosityScene scene, RadiositySolution solution, TexelIndex texels) {
    this.scene = scene;
    this.solution = solution;
    this.texels = texels;
    triangles = scene.triangles();
    own = new TexelFootprint(scene, texels.atlas());
    other = new TexelFootprint(scene, texels.atlas());
    map = new AtlasPage(0, 0, new int[0], new float[0], new float[0], new int[0]);
  }

  /** Returns the side of the texel's square, metres. */
  double size() {
    return own.size();
  }

  int chart() {
    return map.chart()[local];
  }

  /** Returns whether the surface is shaded flat here: the shading normal is the triangle's. */
  boolean flat() {
    return flat;
  }

  /** Moves to a texel that belongs to a chart. */
  void at(int texel) {
    if (page < 0 || texel < texels.first(page) || texel >= texels.first(page) + map.texels()) {
      page = texels.pageOf(texel);
      map = texels.map(page);
    }
    local = texel - texels.first(page);
    triangle = map.triangle()[local];
    version = triangles.version()[triangle];
    own.of(triangle);
    float u = map.u()[local];
    float v = map.v()[local];
    triangles.point(triangle, u, v, point);
    triangles.normal(triangle, facing);
    boolean behind = texels.sides().behind(triangle);
    patch = solution.patches().at(triangle, u, v, behind);
    shade(u, v, behind);
  }

  private void shade(float u, float v, boolean behind) {
    Body body = scene.body(triangle);
    float[] all = body.normals();
    double least = 1;
    for (int k = 0; k < 3; k++) {
      int at = 3 * body.vertex(triangle - body.firstTriangle(), k);
      double cosine = 0;
      for (int axis = 0; axis < 3; axis++) {
        corner[3 * k + axis] = all[at + axis];
        cosine += all[at + axis] * facing[axis];
      }
      least = Math.min(least, cosine);
    }
    flat = !(least > ALIKE) || least > 0.9999;
    double w = 1 - u - v;
    for (int axis = 0; axis < 3; axis++) {
      normal[axis] =
          flat ? facing[axis] : w * corner[axis] + u * corner[3 + axis] + v * corner[6 + axis];
    }
    TriangleMath.normalize(normal);
    if (behind) {
      for (int axis = 0; axis < 3; axis++) {
        normal[axis] = -normal[axis];
        facing[axis] = -facing[axis];
      }
      for (int i = 0; i < 9; i++) {
        corner[i] = -corner[i];
      }
    }
  }

  /** Computes the start of a ray in the middle of the texel, off the surface. */
  void start(double[] out) {
    start(triangle, map.u()[local], map.v()[local], out);
  }

  /**
   * Computes the start of a ray at a point of the texel's square, off the surface.
   *
   * @param s from 0 to 1; with {@code t} the point in the square
   * @return false if the surface ends before the point; then the start lies at its edge
   */
  boolean start(double s, double t, double[] out) {
    int x = local % map.width();
    int y = local / map.width();
    double dx = s - 0.5;
    double dy = t - 0.5;
    if (own.to(x + dx, y + dy)) {
      start(triangle, own.u, own.v, out);
      return true;
    }
    int toX = dx < 0 ? x - 1 : x + 1;
    int toY = dy < 0 ? y - 1 : y + 1;
    if (next(toX, y, x + dx, y + dy, out)
        || next(x, toY, x + dx, y + dy, out)
        || next(toX, toY, x + dx, y + dy, out)) {
      return true;
    }
    own.inside();
    start(triangle, own.u, own.v, out);
    return false;
  }

  /** Uses the triangle of an adjacent texel if the point lies on it; returns whether it does. */
  private boolean next(int toX, int toY, double x, double y, double[] out) {
    if (toX < 0 || toY < 0 || toX >= map.width() || toY >= map.height()) {
      return false;
    }
    int there = toY * map.width() + toX;
    if (map.chart()[there] != map.chart()[local] || map.triangle()[there] == triangle) {
      return false;
    }
    other.of(map.triangle()[there]);
    if (!other.to(x, y)) {
      return false;
    }
    start(other.triangle(), other.u, other.v, out);
    return true;
  }

  private void start(int on, double u, double v, double[] out) {
    double share = Math.min(EDGE, EDGE_TEXELS * own.size() / own.side());
    double inU = u + share * (1 / 3.0 - u);
    double inV = v + share * (1 / 3.0 - v);
    triangles.point(on, inU, inV, out);
    if (!flat && on == triangle) {
      bulge(inU, inV, out);
    }
    for (int axis = 0; axis < 3; axis++) {
      out[axis] += scene.offset() * facing[axis];
    }
  }

  /**
   * Lifts a ray start to the curved surface that the vertex normals imply, so that the triangle
   * does not shadow itself in facets (Hanika 2021, "Hacking the Shadow Terminator").
   */
  private void bulge(double u, double v, double[] out) {
    double x = 0;
    double y = 0;
    double z = 0;
    int at = 9 * triangle;
    float[] all = triangles.corners();
    for (int k = 0; k < 3; k++) {
      double height = 0;
      for (int axis = 0; axis < 3; axis++) {
        height += (out[axis] - all[at + 3 * k + axis]) * corner[3 * k + axis];
      }
      double share = (k == 0 ? 1 - u - v : k == 1 ? u : v) * Math.max(0, -height);
      x += share * corner[3 * k];
      y += share * corner[3 * k + 1];
      z += share * corner[3 * k + 2];
    }
    out[0] += x;
    out[1] += y;
    out[2] += z;
  }
}
