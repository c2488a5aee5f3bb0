package org.selectiverenderer.radiosity.preview;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.joml.Vector3d;
import org.selectiverenderer.formats.image.PngEncoder;
import org.selectiverenderer.radiosity.atlas.Atlas;
import org.selectiverenderer.radiosity.bake.ReinhardToneMapping;
import org.selectiverenderer.radiosity.bake.VertexLitScene;
import org.selectiverenderer.radiosity.scene.Body;
import org.selectiverenderer.radiosity.scene.RadiosityScene;
import org.selectiverenderer.radiosity.solve.RadiositySolution;
import org.selectiverenderer.radiosity.texel.IrradianceAtlas;
import org.selectiverenderer.radiosity.trace.ObjectVersionIndex;
import org.selectiverenderer.radiosity.trace.Ray;
import org.selectiverenderer.radiosity.trace.SceneTriangles;

/**
 * Renders images of a scene's light from one camera; the surface point behind each pixel is found
 * once by ray casting.
 */
public final class PreviewRenderer {
  private static final int WIDTH = 480;
  private static final int HEIGHT = 360;
  private static final byte BACKGROUND = (byte) 0x60;

  private final RadiosityScene scene;
  private final int[] triangle = new int[WIDTH * HEIGHT];
  private final double[] u = new double[WIDTH * HEIGHT];
  private final double[] v = new double[WIDTH * HEIGHT];
  private final boolean[] behind = new boolean[WIDTH * HEIGHT];

  public PreviewRenderer(RadiosityScene scene, PreviewCamera camera) {
    this.scene = scene;
    IntStream.range(0, HEIGHT).parallel().forEach(y -> look(y, camera));
  }

  private void look(int y, PreviewCamera camera) {
    Ray ray = new Ray();
    Vector3d eye = camera.world().getTranslation(new Vector3d());
    Vector3d direction = new Vector3d();
    for (int x = 0; x < WIDTH; x++) {
      int pixel = y * WIDTH + x;
      ray.from(eye, camera.direction(x + 0.5, y + 0.5, WIDTH, HEIGHT, direction));
      ray.length = Double.POSITIVE_INFINITY;
      ray.pass = 0.5;
      scene.visibility().nearest(ray, ObjectVersionIndex.FIXED);
      triangle[pixel] = ray.triangle;
      u[pixel] = ray.u;
      v[pixel] = ray.v;
      behind[pixel] = ray.behind;
    }
  }

  /** Computes the colour of a pixel. */
  @FunctionalInterface
  private interface Painter {
    void paint(int pixel, float[] rgb);
  }

  /** Renders the patches of a solution; returns the bytes of a PNG file. */
  public byte[] of(RadiositySolution solution, double stops) {
    ReinhardToneMapping curve = ReinhardToneMapping.of(scene, solution, stops);
    return draw(
        (pixel, rgb) -> {
          int patch = solution.patches().at(triangle[pixel], u[pixel], v[pixel], behind[pixel]);
          float[] emission = scene.body(triangle[pixel]).emission();
          float[] all = solution.reflected();
          curve.colour(
              all[3 * patch] + emission[0],
              all[3 * patch + 1] + emission[1],
              all[3 * patch + 2] + emission[2],
              rgb,
              0);
        });
  }

  /**
   * Renders the light at the vertices, interpolated as a browser draws it; returns the bytes of a
   * PNG file.
   */
  public byte[] of(VertexLitScene lit) {
    int[] facetOf = facets(lit);
    float[][] colours = new float[scene.bodies().size()][];
    for (int pixel = 0; pixel < triangle.length; pixel++) {
      if (triangle[pixel] != Ray.NOTHING) {
        int body = scene.bodyOf()[triangle[pixel]];
        if (colours[body] == null) {
          colours[body] = lit.colours(body);
        }
      }
    }
    return draw(
        (pixel, rgb) -> {
          int body = scene.bodyOf()[triangle[pixel]];
          int first = lit.facets().firstOfBody()[body];
          double[] weights = new double[2];
          int facet = facet(lit, facetOf, pixel, weights);
          for (int c = 0; c < 3; c++) {
            int at = 9 * (facet - first) + c;
            float[] own = colours[body];
            rgb[c] =
                (float)
                    ((1 - weights[0] - weights[1]) * own[at]
                        + weights[0] * own[at + 3]
                        + weights[1] * own[at + 6]);
          }
        });
  }

  /**
   * Renders the light at the texels with the mean reflectance of each triangle; returns the bytes
   * of a PNG file.
   */
  public byte[] of(IrradianceAtlas light, ReinhardToneMapping curve) {
    return draw(
        (pixel, rgb) -> {
          int source = triangle[pixel];
          Body body = scene.body(source);
          Atlas.Layout layout = light.atlas().layouts().get(scene.bodyOf()[source]);
          double[] arriving = new double[3];
          if (layout.page() >= 0) {
            int own = source - body.firstTriangle();
            light.at(
                layout.page(),
                layout.s(own, u[pixel], v[pixel]),
                layout.t(own, u[pixel], v[pixel]),
                arriving);
          }
          int rho = body.reflectanceAt(source - body.firstTriangle());
          for (int c = 0; c < 3; c++) {
            arriving[c] = body.emission()[c] + body.reflectance()[rho + c] * arriving[c] / Math.PI;
          }
          curve.colour(arriving[0], arriving[1], arriving[2], rgb, 0);
        });
  }

  /**
   * Returns the first facet of each triangle of the scene, or -1; further facets of the triangle
   * follow it.
   */
  private int[] facets(VertexLitScene lit) {
    int[] first = new int[scene.triangles().count()];
    Arrays.fill(first, -1);
    for (int facet = lit.facets().count() - 1; facet >= 0; facet--) {
      first[lit.facets().source()[facet]] = facet;
    }
    return first;
  }

  private int facet(VertexLitScene lit, int[] facetOf, int pixel, double[] weights) {
    int source = triangle[pixel];
    Body body = scene.body(source);
    int end = lit.facets().firstOfBody()[scene.bodyOf()[source] + 1];
    double[] point = new double[3];
    scene.triangles().point(source, u[pixel], v[pixel], point);
    if (end - lit.facets().firstOfBody()[scene.bodyOf()[source]] == body.triangles()) {
      weights[0] = u[pixel];
      weights[1] = v[pixel];
      return facetOf[source];
    }
    int best = facetOf[source];
    double least = Double.POSITIVE_INFINITY;
    double[] own = new double[2];
    for (int facet = facetOf[source]; facet < end; facet++) {
      if (lit.facets().source()[facet] == source) {
        double outside = SceneTriangles.weights(lit.facets().corners(), facet, point, own);
        if (outside < least) {
          least = outside;
          best = facet;
          System.arraycopy(own, 0, weights, 0, 2);
        }
      }
    }
    return best;
  }

  private byte[] draw(Painter painter) {
    byte[] rgb = new byte[3 * WIDTH * HEIGHT];
    IntStream.range(0, HEIGHT)
        .parallel()
        .forEach(
            y -> {
              float[] colour = new float[3];
              for (int pixel = y * WIDTH; pixel < (y + 1) * WIDTH; pixel++) {
                if (triangle[pixel] == Ray.NOTHING) {
                  Arrays.fill(rgb, 3 * pixel, 3 * pixel + 3, BACKGROUND);
                  continue;
                }
                painter.paint(pixel, colour);
                for (int c = 0; c < 3; c++) {
                  rgb[3 * pixel + c] = (byte) Math.round(255 * colour[c]);
                }
              }
            });
    return PngEncoder.of(WIDTH, HEIGHT, rgb);
  }
}
