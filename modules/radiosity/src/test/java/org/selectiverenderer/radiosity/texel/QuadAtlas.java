package org.selectiverenderer.radiosity.texel;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.selectiverenderer.radiosity.atlas.Atlas;
import org.selectiverenderer.radiosity.atlas.AtlasPage;
import org.selectiverenderer.radiosity.scene.Body;
import org.selectiverenderer.radiosity.scene.RadiosityScene;
import org.selectiverenderer.radiosity.trace.SceneTriangles;

/**
 * Atlases of scenes whose bodies are made of rectangles of two triangles each: a page per body, a
 * chart per rectangle, one above the other, with a row of no chart in between.
 */
final class QuadAtlas {
  private final RadiosityScene scene;
  private final double density;

  private QuadAtlas(RadiosityScene scene, double density) {
    this.scene = scene;
    this.density = density;
  }

  /**
   * @param density texels per metre
   */
  static Atlas of(RadiosityScene scene, double density) {
    QuadAtlas maker = new QuadAtlas(scene, density);
    List<AtlasPage> pages = new ArrayList<>();
    List<Atlas.Layout> layouts = new ArrayList<>();
    for (Body body : scene.bodies()) {
      maker.page(body, pages, layouts);
    }
    return new Atlas(pages, layouts);
  }

  /** Texels across and up, and the corners of both triangles in texels, x and y. */
  private record Quad(int across, int up, double[] corners) {}

  private Quad quad(int triangle) {
    float[] all = scene.triangles().corners();
    double[] normal = new double[3];
    scene.triangles().normal(triangle, normal);
    double[] x = new double[3];
    double length = 0;
    for (int i = 0; i < 3; i++) {
      x[i] = all[9 * triangle + 3 + i] - all[9 * triangle + i];
      length += x[i] * x[i];
    }
    for (int i = 0; i < 3; i++) {
      x[i] /= Math.sqrt(length);
    }
    double[] corners = new double[12];
    double[] low = {1e9, 1e9};
    double[] high = {-1e9, -1e9};
    for (int k = 0; k < 6; k++) {
      double[] own = new double[2];
      for (int i = 0; i < 3; i++) {
        double y = normal[(i + 1) % 3] * x[(i + 2) % 3] - normal[(i + 2) % 3] * x[(i + 1) % 3];
        own[0] += all[9 * triangle + 3 * k + i] * x[i];
        own[1] += all[9 * triangle + 3 * k + i] * y;
      }
      for (int i = 0; i < 2; i++) {
        corners[2 * k + i] = own[i];
        low[i] = Math.min(low[i], own[i]);
        high[i] = Math.max(high[i], own[i]);
      }
    }
    int across = (int) Math.max(1, Math.round(density * (high[0] - low[0])));
    int up = (int) Math.max(1, Math.round(density * (high[1] - low[1])));
    for (int k = 0; k < 6; k++) {
      corners[2 * k] = (corners[2 * k] - low[0]) / (high[0] - low[0]) * across;
      corners[2 * k + 1] = (corners[2 * k + 1] - low[1]) / (high[1] - low[1]) * up;
    }
    return new Quad(across, up, corners);
  }

  private void page(Body body, List<AtlasPage> pages, List<Atlas.Layout> layouts) {
    List<Quad> quads = new ArrayList<>();
    int width = 1;
    int height = 0;
    for (int i = 0; i < body.triangles(); i += 2) {
      Quad quad = quad(body.firstTriangle() + i);
      quads.add(quad);
      width = Math.max(width, quad.across());
      height += quad.up() + 1;
    }
    int[] triangle = new int[width * height];
    int[] chart = new int[width * height];
    float[] u = new float[width * height];
    float[] v = new float[width * height];
    float[] st = new float[6 * body.triangles()];
    Arrays.fill(triangle, AtlasPage.NONE);
    Arrays.fill(chart, AtlasPage.NONE);
    int bottom = 0;
    double[] weights = new double[2];
    for (int q = 0; q < quads.size(); q++) {
      Quad quad = quads.get(q);
      float[] flat = new float[18];
      for (int k = 0; k < 6; k++) {
        flat[3 * k] = (float) quad.corners()[2 * k];
        flat[3 * k + 1] = (float) quad.corners()[2 * k + 1];
        st[12 * q + 2 * k] = flat[3 * k] / width;
        st[12 * q + 2 * k + 1] = (bottom + flat[3 * k + 1]) / height;
      }
      for (int i = 0; i < quad.across() * quad.up(); i++) {
        int x = i % quad.across();
        int y = i / quad.across();
        double[] point = {x + 0.5, y + 0.5, 0};
        int there = (bottom + y) * width + x;
        double first = SceneTriangles.weights(flat, 0, point, weights);
        int half = first < 1e-6 ? 0 : 1;
        SceneTriangles.weights(flat, half, point, weights);
        triangle[there] = body.firstTriangle() + 2 * q + half;
        chart[there] = q;
        u[there] = (float) weights[0];
        v[there] = (float) weights[1];
      }
      bottom += quad.up() + 1;
    }
    layouts.add(new Atlas.Layout(pages.size(), st));
    pages.add(new AtlasPage(width, height, triangle, u, v, chart));
  }
}
