package org.selectiverenderer.radiosity.bake;

import org.selectiverenderer.radiosity.mesh.RadiosityMesh;

/**
 * Fills buried vertices with the mean light of their neighbours, ring by ring from the border of
 * the buried region inwards.
 */
final class VertexHoleFilling {
  private static final int ROUNDS = 200;

  private VertexHoleFilling() {}

  static void fill(RadiosityMesh facets, float[] light, boolean[] valid) {
    int[] vertexOf = facets.vertexOf();
    for (int round = 0; round < ROUNDS; round++) {
      float[] sums = new float[light.length];
      int[] counts = new int[valid.length];
      boolean any = false;
      for (int i = 0; i < vertexOf.length; i++) {
        int vertex = vertexOf[i];
        if (valid[vertex]) {
          continue;
        }
        int first = i - i % 3;
        for (int k = first; k < first + 3; k++) {
          if (valid[vertexOf[k]]) {
            counts[vertex]++;
            any = true;
            for (int c = 0; c < 3; c++) {
              sums[3 * vertex + c] += light[3 * vertexOf[k] + c];
            }
          }
        }
      }
      if (!any) {
        return;
      }
      for (int vertex = 0; vertex < valid.length; vertex++) {
        if (counts[vertex] > 0) {
          valid[vertex] = true;
          for (int c = 0; c < 3; c++) {
            light[3 * vertex + c] = sums[3 * vertex + c] / counts[vertex];
          }
        }
      }
    }
  }
}
