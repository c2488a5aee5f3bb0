package org.selectiverenderer.models.simplify;

import java.util.Arrays;
import java.util.Comparator;
import java.util.stream.IntStream;

/**
 * The connected components of a mesh, by union-find: triangles are connected by vertices in the
 * same position.
 */
final class ConnectedComponents {
  private final MergedMesh mesh;
  private final int[] parent;
  private final int[] first;

  private ConnectedComponents(MergedMesh mesh) {
    this.mesh = mesh;
    this.first = PositionRemap.first(mesh, false);
    this.parent = IntStream.range(0, mesh.vertexCount()).toArray();
    int[] indices = mesh.indices();
    for (int i = 0; i < indices.length; i += 3) {
      join(first[indices[i]], first[indices[i + 1]]);
      join(first[indices[i]], first[indices[i + 2]]);
    }
  }

  private void join(int a, int b) {
    int rootOfA = root(a);
    int rootOfB = root(b);
    parent[Math.max(rootOfA, rootOfB)] = Math.min(rootOfA, rootOfB);
  }

  private int root(int vertex) {
    int v = vertex;
    while (parent[v] != v) {
      parent[v] = parent[parent[v]];
      v = parent[v];
    }
    return v;
  }

  /**
   * Removes the smallest components as long as at least the wanted number of polygons remains; at
   * least one component stays.
   */
  static MergedMesh withoutSmallest(MergedMesh mesh, int polygons) {
    return new ConnectedComponents(mesh).withoutSmallest(polygons);
  }

  private MergedMesh withoutSmallest(int polygons) {
    int[] indices = mesh.indices();
    int[] counts = new int[parent.length];
    double[] areas = new double[parent.length];
    for (int t = 0; t < mesh.polygons(); t++) {
      int piece = root(first[indices[3 * t]]);
      counts[piece]++;
      areas[piece] += TriangleAreas.area(mesh.vertices(), indices, t);
    }
    int[] bySize =
        IntStream.range(0, counts.length)
            .filter(piece -> counts[piece] > 0)
            .boxed()
            .sorted(Comparator.comparingDouble((Integer piece) -> areas[piece]))
            .mapToInt(Integer::intValue)
            .toArray();
    boolean[] dropped = new boolean[counts.length];
    int left = mesh.polygons();
    for (int i = 0; i < bySize.length - 1 && left > polygons; i++) {
      if (left - counts[bySize[i]] >= polygons) {
        dropped[bySize[i]] = true;
        left -= counts[bySize[i]];
      }
    }
    int[] kept = new int[3 * left];
    int count = 0;
    for (int i = 0; i < indices.length; i += 3) {
      if (!dropped[root(first[indices[i]])]) {
        System.arraycopy(indices, i, kept, count, 3);
        count += 3;
      }
    }
    return mesh.with(mesh.vertices(), Arrays.copyOf(kept, count)).compact();
  }
}
