package org.selectiverenderer.radiosity.bake;

import org.selectiverenderer.radiosity.mesh.RadiosityMesh;
import org.selectiverenderer.radiosity.scene.Body;
import org.selectiverenderer.radiosity.scene.RadiosityScene;
import org.selectiverenderer.radiosity.solve.RadiositySolution;

/**
 * A scene with its light at the vertices.
 *
 * @param curve the tone mapping from light to display colours
 * @param rays number of rays cast
 */
public record VertexLitScene(
    RadiosityScene scene,
    RadiosityMesh facets,
    VertexLight light,
    RadiositySolution solution,
    ReinhardToneMapping curve,
    long rays)
    implements LightingResult {

  @Override
  public boolean complete() {
    return light.complete();
  }

  @Override
  public int polygons() {
    return facets.count();
  }

  /**
   * Returns the display colours of the corners of a body's facets: r, g, b, 0 .. 1, nine numbers
   * per facet. Corners that share a vertex have one colour: reflectances that differ from facet to
   * facet are averaged there.
   */
  public float[] colours(int body) {
    int first = facets.firstOfBody()[body];
    int count = facets.firstOfBody()[body + 1] - first;
    Body of = scene.bodies().get(body);
    int[] local = new int[3 * count];
    float[] reflectance = reflectances(of, first, count, local);
    float[] colours = new float[9 * count];
    for (int corner = 0; corner < 3 * count; corner++) {
      int vertex = facets.vertexOf()[3 * first + corner];
      double[] radiance = new double[3];
      for (int c = 0; c < 3; c++) {
        radiance[c] =
            of.emission()[c]
                + reflectance[3 * local[corner] + c] * light.irradiance()[3 * vertex + c] / Math.PI;
      }
      // A transparent surface is blended with what lies behind it by its alpha, so its colour is
      // that of the opaque share alone.
      double opaque = Math.max(0.05, 1 - of.transmittance());
      curve.colour(
          radiance[0] / opaque, radiance[1] / opaque, radiance[2] / opaque, colours, 3 * corner);
    }
    return colours;
  }

  /**
   * Returns the mean reflectance at each vertex of a body; {@code local} receives the number of the
   * vertex at each corner.
   */
  private float[] reflectances(Body body, int first, int count, int[] local) {
    if (body.reflectance().length == 3) {
      return body.reflectance();
    }
    java.util.Map<Integer, Integer> numbers = new java.util.HashMap<>();
    for (int corner = 0; corner < 3 * count; corner++) {
      int vertex = facets.vertexOf()[3 * first + corner];
      local[corner] = numbers.computeIfAbsent(vertex, key -> numbers.size());
    }
    float[] sums = new float[3 * numbers.size()];
    int[] counts = new int[numbers.size()];
    for (int corner = 0; corner < 3 * count; corner++) {
      int triangle = facets.source()[first + corner / 3] - body.firstTriangle();
      counts[local[corner]]++;
      for (int c = 0; c < 3; c++) {
        sums[3 * local[corner] + c] += body.reflectance()[body.reflectanceAt(triangle) + c];
      }
    }
    for (int i = 0; i < sums.length; i++) {
      sums[i] /= counts[i / 3];
    }
    return sums;
  }
}
