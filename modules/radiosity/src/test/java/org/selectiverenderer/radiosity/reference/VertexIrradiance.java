package org.selectiverenderer.radiosity.reference;

import org.selectiverenderer.radiosity.bake.VertexLitScene;
import org.selectiverenderer.radiosity.mesh.RadiosityMesh;
import org.selectiverenderer.radiosity.trace.SceneTriangles;

/** Light at the vertices of facets, interpolated between them as it is drawn. */
final class VertexIrradiance implements Irradiance {
  private final VertexLitScene lit;

  /** The facets of each triangle: where they begin in the list, and the list. */
  private final int[] first;

  private final int[] facets;

  VertexIrradiance(VertexLitScene lit) {
    this.lit = lit;
    int[] source = lit.facets().source();
    first = new int[lit.scene().triangles().count() + 1];
    for (int triangle : source) {
      first[triangle + 1]++;
    }
    for (int i = 1; i < first.length; i++) {
      first[i] += first[i - 1];
    }
    facets = new int[source.length];
    int[] next = first.clone();
    for (int facet = 0; facet < source.length; facet++) {
      facets[next[source[facet]]++] = facet;
    }
  }

  @Override
  public void at(int triangle, double u, double v, double[] out) {
    double[] point = new double[3];
    double[] weights = new double[2];
    double[] own = new double[2];
    lit.scene().triangles().point(triangle, u, v, point);
    RadiosityMesh all = lit.facets();
    int best = -1;
    double least = Double.POSITIVE_INFINITY;
    for (int i = first[triangle]; i < first[triangle + 1]; i++) {
      double outside = SceneTriangles.weights(all.corners(), facets[i], point, own);
      if (outside < least) {
        least = outside;
        best = facets[i];
        weights[0] = own[0];
        weights[1] = own[1];
      }
    }
    float[] light = lit.light().irradiance();
    for (int c = 0; c < 3; c++) {
      out[c] =
          (1 - weights[0] - weights[1]) * light[3 * all.vertexOf()[3 * best] + c]
              + weights[0] * light[3 * all.vertexOf()[3 * best + 1] + c]
              + weights[1] * light[3 * all.vertexOf()[3 * best + 2] + c];
    }
  }
}
