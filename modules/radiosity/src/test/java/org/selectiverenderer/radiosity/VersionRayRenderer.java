package org.selectiverenderer.radiosity;

import org.joml.Vector3d;
import org.selectiverenderer.radiosity.atlas.Atlas;
import org.selectiverenderer.radiosity.bake.LightmapImage;
import org.selectiverenderer.radiosity.bake.LightmapImageSet;
import org.selectiverenderer.radiosity.bake.LightmappedScene;
import org.selectiverenderer.radiosity.scene.Photometry;
import org.selectiverenderer.radiosity.trace.Ray;

/** Pictures of a lit object's versions, as a browser shows them, drawn by rays. */
final class VersionRayRenderer {
  private final LightmappedScene lit;
  private final LightmapImageSet pictures;
  private final Ray ray = new Ray();

  VersionRayRenderer(LightmappedScene lit) {
    this.lit = lit;
    pictures = LightmapImageSet.of(lit);
  }

  /**
   * How two versions differ.
   *
   * @param mean difference of luminance, in shares of white, where both are seen
   * @param far the share of pixels where it is above 12/255, as beside an edge that is elsewhere
   * @param pixels that both cover
   */
  record Difference(double mean, double far, int pixels) {}

  /** Compares two versions seen from an eye, in a picture of so many pixels each way. */
  Difference compare(int one, int other, Vector3d eye, Vector3d target, int size) {
    Vector3d forward = target.sub(eye, new Vector3d()).normalize();
    Vector3d right = forward.cross(0, 1, 0, new Vector3d()).normalize();
    Vector3d up = right.cross(forward, new Vector3d());
    double sum = 0;
    int far = 0;
    int pixels = 0;
    for (int y = 0; y < size; y++) {
      for (int x = 0; x < size; x++) {
        Vector3d direction =
            new Vector3d(forward)
                .fma(0.7 * ((x + 0.5) / size - 0.5), right)
                .fma(0.7 * ((y + 0.5) / size - 0.5), up)
                .normalize();
        double a = seen(one, eye, direction);
        double b = seen(other, eye, direction);
        if (a >= 0 && b >= 0) {
          sum += Math.abs(a - b);
          far += Math.abs(a - b) > 12.0 / 255 ? 1 : 0;
          pixels++;
        }
      }
    }
    return new Difference(sum / Math.max(1, pixels), (double) far / Math.max(1, pixels), pixels);
  }

  /** The luminance that is shown of a version in a direction; -1 if something else is seen. */
  private double seen(int version, Vector3d eye, Vector3d direction) {
    ray.from(
        new double[] {eye.x, eye.y, eye.z}, new double[] {direction.x, direction.y, direction.z});
    ray.length = Double.POSITIVE_INFINITY;
    ray.pass = 0.5;
    lit.scene().visibility().nearest(ray, version);
    if (ray.triangle == Ray.NOTHING
        || lit.scene().triangles().version()[ray.triangle] != version
        || layout(ray.triangle).page() < 0
        || pictures.use().apart(lit.scene().bodyOf()[ray.triangle])) {
      return -1;
    }
    int body = lit.scene().bodyOf()[ray.triangle];
    Atlas.Layout layout = layout(ray.triangle);
    int own = ray.triangle - lit.scene().bodies().get(body).firstTriangle();
    return between(
        pictures.pictures().get(layout.page()),
        layout.s(own, ray.u, ray.v),
        layout.t(own, ray.u, ray.v));
  }

  private Atlas.Layout layout(int triangle) {
    return lit.atlas().layouts().get(lit.scene().bodyOf()[triangle]);
  }

  /** The luminance between four pixels, as OpenGL filters a picture that does not repeat. */
  private static double between(LightmapImage picture, double s, double t) {
    double x = Math.max(0, Math.min(picture.width() - 1, s * picture.width() - 0.5));
    double y = Math.max(0, Math.min(picture.height() - 1, (1 - t) * picture.height() - 0.5));
    int left = (int) x;
    int top = (int) y;
    double[] rgb = new double[3];
    for (int k = 0; k < 4; k++) {
      int column = Math.min(picture.width() - 1, left + (k & 1));
      int row = Math.min(picture.height() - 1, top + (k >> 1));
      double along = (k & 1) == 0 ? 1 - (x - left) : x - left;
      double across = k < 2 ? 1 - (y - top) : y - top;
      for (int c = 0; c < 3; c++) {
        int at = 3 * (row * picture.width() + column) + c;
        rgb[c] += along * across * (picture.rgb()[at] & 0xff) / 255;
      }
    }
    return Photometry.luminance((float) rgb[0], (float) rgb[1], (float) rgb[2]);
  }
}
