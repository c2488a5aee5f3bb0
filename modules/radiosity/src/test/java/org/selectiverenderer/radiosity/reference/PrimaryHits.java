package org.selectiverenderer.radiosity.reference;

import java.util.stream.IntStream;
import org.joml.Vector3d;
import org.selectiverenderer.radiosity.scene.RadiosityScene;
import org.selectiverenderer.radiosity.trace.ObjectVersionIndex;
import org.selectiverenderer.radiosity.trace.Ray;

/**
 * What a picture shows: the places that rays through each pixel meet. Both the reference and the
 * lit result are looked at in exactly these, so that their difference is one of light only.
 *
 * @param side rays through a pixel along each axis: {@code side * side} places to a pixel
 * @param triangle by place; {@link Ray#NOTHING} for the background
 * @param u weight of the triangle's second corner
 * @param v weight of its third corner
 * @param behind whether it was met from behind
 */
record PrimaryHits(
    int width, int height, int side, int[] triangle, float[] u, float[] v, boolean[] behind) {
  /** A step beyond a surface that shows nothing from behind, as a share of the extent. */
  private static final double STEP = 1e-6;

  static PrimaryHits of(
      RadiosityScene scene, ReferenceScene.View view, int width, int height, int side) {
    int count = width * height * side * side;
    PrimaryHits hits =
        new PrimaryHits(
            width,
            height,
            side,
            new int[count],
            new float[count],
            new float[count],
            new boolean[count]);
    IntStream.range(0, height).parallel().forEach(row -> hits.look(scene, view, row));
    return hits;
  }

  int pixels() {
    return width * height;
  }

  /** Places to a pixel; those of pixel i are i times so many and the following. */
  int places() {
    return side * side;
  }

  /** The share of a pixel that is not background. */
  double covered(int pixel) {
    int met = 0;
    for (int i = pixel * places(); i < (pixel + 1) * places(); i++) {
      met += triangle[i] == Ray.NOTHING ? 0 : 1;
    }
    return (double) met / places();
  }

  private void look(RadiosityScene scene, ReferenceScene.View view, int row) {
    Ray ray = new Ray();
    for (int column = 0; column < width; column++) {
      for (int k = 0; k < places(); k++) {
        double x = column + (k % side + 0.5) / side;
        double y = row + (k / side + 0.5) / side;
        // Panes: as many of the places see through them as they are transparent. Neighbouring
        // numbers must not belong to neighbouring places.
        ray.pass = (k * 7 % places() + 0.5) / places();
        look(scene, ray, view.eye(), view.direction(x, y, width, height));
        int at = (row * width + column) * places() + k;
        triangle[at] = ray.triangle;
        u[at] = (float) ray.u;
        v[at] = (float) ray.v;
        behind[at] = ray.behind;
      }
    }
  }

  /** What is solid is not drawn from behind (X3D 4.0, 11.2.3 solid). */
  private static void look(RadiosityScene scene, Ray ray, Vector3d eye, Vector3d direction) {
    Vector3d from = new Vector3d(eye);
    do {
      ray.from(from, direction);
      ray.length = Double.POSITIVE_INFINITY;
      scene.visibility().nearest(ray, ObjectVersionIndex.FIXED);
      if (ray.triangle != Ray.NOTHING) {
        from.fma(ray.length + STEP * scene.extent(), direction);
      }
    } while (ray.triangle != Ray.NOTHING
        && ray.behind
        && !scene.triangles().twoSided()[ray.triangle]);
  }
}
