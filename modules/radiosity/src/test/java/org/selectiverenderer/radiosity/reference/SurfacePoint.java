package org.selectiverenderer.radiosity.reference;

import org.selectiverenderer.radiosity.scene.Body;
import org.selectiverenderer.radiosity.scene.RadiosityScene;
import org.selectiverenderer.radiosity.trace.Ray;

/** A place on a surface, as seen from one of its sides; used again and again by one thread. */
final class SurfacePoint {
  final double[] place = new double[3];

  /** Unit vectors to the side seen: of the triangle, and interpolated between its corners. */
  final double[] flat = new double[3];

  final double[] normal = new double[3];

  /** Shares of light that its opaque part throws back, r, g, b. */
  final double[] albedo = new double[3];

  /** Radiance of its opaque part, r, g, b, cd/m2. */
  final double[] glow = new double[3];

  int body;

  /** False when it is seen from behind and has one side only: then it throws back nothing. */
  boolean front;

  private final RadiosityScene scene;

  SurfacePoint(RadiosityScene scene) {
    this.scene = scene;
  }

  /** What a ray has met. */
  void at(Ray ray) {
    at(ray.triangle, ray.u, ray.v, ray.behind);
  }

  /**
   * @param u weight of the second corner
   * @param v weight of the third corner
   */
  void at(int triangle, double u, double v, boolean behind) {
    body = scene.bodyOf()[triangle];
    Body of = scene.bodies().get(body);
    int own = triangle - of.firstTriangle();
    front = !behind || scene.triangles().twoSided()[triangle];
    scene.triangles().normal(triangle, flat);
    scene.triangles().point(triangle, u, v, place);
    interpolate(of, own, u, v);
    double sign = behind ? -1 : 1;
    double opaque = 1 - of.transmittance();
    int at = of.reflectanceAt(own);
    for (int i = 0; i < 3; i++) {
      flat[i] *= sign;
      normal[i] *= sign;
      // The scene has both as seen beside what shines through; a ray has met the opaque part.
      albedo[i] = opaque > 0 ? of.reflectance()[at + i] / opaque : 0;
      glow[i] = opaque > 0 ? of.emission()[i] / opaque : 0;
    }
  }

  private void interpolate(Body of, int own, double u, double v) {
    double length = 0;
    double along = 0;
    for (int axis = 0; axis < 3; axis++) {
      normal[axis] =
          (1 - u - v) * of.normals()[3 * of.vertex(own, 0) + axis]
              + u * of.normals()[3 * of.vertex(own, 1) + axis]
              + v * of.normals()[3 * of.vertex(own, 2) + axis];
      length += normal[axis] * normal[axis];
      along += normal[axis] * flat[axis];
    }
    boolean usable = length > 1e-12 && along > 0;
    for (int axis = 0; axis < 3; axis++) {
      normal[axis] = usable ? normal[axis] / Math.sqrt(length) : flat[axis];
    }
  }
}
