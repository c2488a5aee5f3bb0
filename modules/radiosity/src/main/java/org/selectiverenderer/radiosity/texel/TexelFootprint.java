package org.selectiverenderer.radiosity.texel;

import org.selectiverenderer.radiosity.atlas.Atlas;
import org.selectiverenderer.radiosity.atlas.AtlasPage;
import org.selectiverenderer.radiosity.scene.Body;
import org.selectiverenderer.radiosity.scene.RadiosityScene;

/** The affine map from texel coordinates of a page to barycentric weights of one triangle. */
final class TexelFootprint {
  private final RadiosityScene scene;
  private final Atlas atlas;
  private final double[] normal = new double[3];
  private int triangle = AtlasPage.NONE;
  private double u0;
  private double ux;
  private double uy;
  private double v0;
  private double vx;
  private double vy;
  private double size;
  private double side;

  /** Barycentric weights of the second and third corner at the last point. */
  double u;

  double v;

  TexelFootprint(RadiosityScene scene, Atlas atlas) {
    this.scene = scene;
    this.atlas = atlas;
  }

  int triangle() {
    return triangle;
  }

  /** Returns the side of a texel's square on the triangle, metres. */
  double size() {
    return size;
  }

  /** Returns the side of a square with the triangle's area, metres; above 0. */
  double side() {
    return side;
  }

  void of(int wanted) {
    if (wanted == triangle) {
      return;
    }
    triangle = wanted;
    Body body = scene.body(wanted);
    Atlas.Layout layout = atlas.layouts().get(scene.bodyOf()[wanted]);
    AtlasPage map = atlas.pages().get(layout.page());
    float[] st = layout.st();
    int at = 6 * (wanted - body.firstTriangle());
    double ax = (double) st[at] * map.width() - 0.5;
    double ay = (double) st[at + 1] * map.height() - 0.5;
    double bx = (double) st[at + 2] * map.width() - 0.5 - ax;
    double by = (double) st[at + 3] * map.height() - 0.5 - ay;
    double cx = (double) st[at + 4] * map.width() - 0.5 - ax;
    double cy = (double) st[at + 5] * map.height() - 0.5 - ay;
    double twice = bx * cy - by * cx;
    double area = scene.triangles().normal(wanted, normal);
    side = Math.max(1e-9, Math.sqrt(area));
    if (Math.abs(twice) < 1e-9) {
      // A degenerate triangle on the page: every point maps to the triangle's centroid.
      u0 = 1 / 3.0;
      v0 = 1 / 3.0;
      ux = 0;
      uy = 0;
      vx = 0;
      vy = 0;
      size = Math.sqrt(area);
      return;
    }
    ux = cy / twice;
    uy = -cx / twice;
    vx = -by / twice;
    vy = bx / twice;
    u0 = -ux * ax - uy * ay;
    v0 = -vx * ax - vy * ay;
    size = Math.sqrt(area / (Math.abs(twice) / 2));
  }

  /**
   * Maps a point of the page, in texels with whole numbers at centres; returns whether it lies
   * inside of the triangle.
   */
  boolean to(double x, double y) {
    u = u0 + ux * x + uy * y;
    v = v0 + vx * x + vy * y;
    return u >= 0 && v >= 0 && u + v <= 1;
  }

  /** Moves the last point onto the triangle if it lies outside. */
  void inside() {
    u = Math.max(0, u);
    v = Math.max(0, v);
    double sum = u + v;
    if (sum > 1) {
      u /= sum;
      v /= sum;
    }
  }
}
