package org.selectiverenderer.polygon.simplify;

import static org.lwjgl.util.meshoptimizer.MeshOptimizer.meshopt_SimplifyPermissive;
import static org.lwjgl.util.meshoptimizer.MeshOptimizer.meshopt_SimplifyPrune;
import static org.lwjgl.util.meshoptimizer.MeshOptimizer.meshopt_SimplifyRegularizeLight;
import static org.lwjgl.util.meshoptimizer.MeshOptimizer.meshopt_SimplifyVertex_Protect;
import static org.lwjgl.util.meshoptimizer.MeshOptimizer.meshopt_simplifySloppy;
import static org.lwjgl.util.meshoptimizer.MeshOptimizer.meshopt_simplifyWithUpdate;

import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import org.lwjgl.system.MemoryUtil;

/**
 * Reduction by meshoptimizer: edges collapse in order of the error that they cause (Garland and
 * Heckbert 1997, with attributes after Hoppe 1999), and the vertices that are left move to where
 * they lie best.
 */
final class EdgeCollapse {
  private static final float COLOR = 0.2f;
  private static final float TEX_COORD = 0.1f;

  /** No limit; the largest float would overflow when squared. */
  static final float ANY_ERROR = 1e9f;

  private static final int VERTEX_BYTES = Float.BYTES * JoinedMesh.STRIDE;

  private EdgeCollapse() {}

  /**
   * Collapses edges until so many polygons are left, or none can go without a larger error. The
   * outcome may have fewer polygons than asked for.
   *
   * @param largestError as a share of the mesh's largest extent
   */
  static JoinedMesh run(
      JoinedMesh mesh, int polygons, float largestError, Freedom freedom, Style style) {
    boolean keepSeams = freedom == Freedom.KEEP_SEAMS;
    int options =
        meshopt_SimplifyPermissive
            | (freedom == Freedom.ANY_PIECE ? meshopt_SimplifyPrune : 0)
            | (style.regular ? meshopt_SimplifyRegularizeLight : 0);
    float[] weighed = weights(mesh, style.normalWeight);
    int count = mesh.vertexCount();
    // The attributes begin after the first position, so the last vertex needs room to spare.
    FloatBuffer vertices = MemoryUtil.memAllocFloat(mesh.vertices().length + JoinedMesh.NORMAL);
    IntBuffer indices = MemoryUtil.memAllocInt(mesh.indices().length);
    ByteBuffer locks = MemoryUtil.memCalloc(count);
    FloatBuffer weights = MemoryUtil.memAllocFloat(weighed.length);
    try {
      vertices.put(0, mesh.vertices());
      indices.put(0, mesh.indices());
      weights.put(0, weighed);
      if (keepSeams) {
        protect(Seams.visible(mesh), locks);
      }
      int left =
          (int)
              meshopt_simplifyWithUpdate(
                  indices,
                  vertices,
                  count,
                  VERTEX_BYTES,
                  vertices.slice(JoinedMesh.NORMAL, mesh.vertices().length),
                  VERTEX_BYTES,
                  weights,
                  locks,
                  3L * polygons,
                  largestError,
                  options,
                  null);
      float[] moved = new float[mesh.vertices().length];
      int[] remaining = new int[left];
      vertices.get(0, moved);
      indices.get(0, remaining);
      return mesh.with(moved, remaining);
    } finally {
      MemoryUtil.memFree(vertices);
      MemoryUtil.memFree(indices);
      MemoryUtil.memFree(locks);
      MemoryUtil.memFree(weights);
    }
  }

  /** Nothing for what no vertex has: every attribute with a weight costs time. */
  private static float[] weights(JoinedMesh mesh, float normal) {
    float color = mesh.has(JoinedMesh.COLOR, JoinedMesh.TEX_COORD) ? COLOR : 0;
    float texCoord = mesh.has(JoinedMesh.TEX_COORD, JoinedMesh.PART) ? TEX_COORD : 0;
    return new float[] {normal, normal, normal, color, color, color, color, texCoord, texCoord};
  }

  private static void protect(boolean[] seams, ByteBuffer locks) {
    for (int vertex = 0; vertex < seams.length; vertex++) {
      if (seams[vertex]) {
        locks.put(vertex, (byte) meshopt_SimplifyVertex_Protect);
      }
    }
  }

  /** Joins vertices that are near each other, whatever they belong to, on a grid. */
  static JoinedMesh cluster(JoinedMesh mesh, int polygons) {
    FloatBuffer vertices = MemoryUtil.memAllocFloat(mesh.vertices().length);
    IntBuffer indices = MemoryUtil.memAllocInt(mesh.indices().length);
    IntBuffer joined = MemoryUtil.memAllocInt(mesh.indices().length);
    try {
      vertices.put(0, mesh.vertices());
      indices.put(0, mesh.indices());
      int left =
          (int)
              meshopt_simplifySloppy(
                  joined,
                  indices,
                  vertices,
                  mesh.vertexCount(),
                  VERTEX_BYTES,
                  null,
                  3L * polygons,
                  ANY_ERROR,
                  null);
      int[] remaining = new int[left];
      joined.get(0, remaining);
      return mesh.with(mesh.vertices(), remaining);
    } finally {
      MemoryUtil.memFree(vertices);
      MemoryUtil.memFree(indices);
      MemoryUtil.memFree(joined);
    }
  }
}
