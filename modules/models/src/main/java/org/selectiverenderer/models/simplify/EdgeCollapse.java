package org.selectiverenderer.models.simplify;

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
 * Simplifies meshes by edge collapses with meshoptimizer: edges collapse in order of the error that
 * they cause (Garland and Heckbert 1997, with attributes after Hoppe 1999), and the remaining
 * vertices move to the positions of least error.
 */
final class EdgeCollapse {
  private static final float COLOR = 0.2f;
  private static final float TEX_COORD = 0.1f;

  /** Stands for no error limit; the largest float would overflow when squared. */
  static final float ANY_ERROR = 1e9f;

  private static final int VERTEX_BYTES = Float.BYTES * MergedMesh.STRIDE;

  private EdgeCollapse() {}

  /**
   * Collapses edges until that many polygons are left, or no edge can collapse within the error.
   * The result may have fewer polygons than asked for.
   *
   * @param largestError largest error allowed, as a share of the mesh's largest extent
   */
  static MergedMesh run(
      MergedMesh mesh,
      int polygons,
      float largestError,
      TopologyConstraint freedom,
      SimplificationPreset style) {
    boolean keepSeams = freedom == TopologyConstraint.KEEP_SEAMS;
    int options =
        meshopt_SimplifyPermissive
            | (freedom == TopologyConstraint.ANY_PIECE ? meshopt_SimplifyPrune : 0)
            | (style.regular ? meshopt_SimplifyRegularizeLight : 0);
    float[] weighed = weights(mesh, style.normalWeight);
    int count = mesh.vertexCount();
    // The attribute array begins after the first position, so the buffer needs padding behind the
    // last vertex.
    FloatBuffer vertices = MemoryUtil.memAllocFloat(mesh.vertices().length + MergedMesh.NORMAL);
    IntBuffer indices = MemoryUtil.memAllocInt(mesh.indices().length);
    ByteBuffer locks = MemoryUtil.memCalloc(count);
    FloatBuffer weights = MemoryUtil.memAllocFloat(weighed.length);
    try {
      vertices.put(0, mesh.vertices());
      indices.put(0, mesh.indices());
      weights.put(0, weighed);
      if (keepSeams) {
        protect(PositionRemap.visible(mesh), locks);
      }
      int left =
          (int)
              meshopt_simplifyWithUpdate(
                  indices,
                  vertices,
                  count,
                  VERTEX_BYTES,
                  vertices.slice(MergedMesh.NORMAL, mesh.vertices().length),
                  VERTEX_BYTES,
                  weights,
                  locks,
                  target(mesh, polygons),
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

  /** Returns the number of indices to keep, which the library wants within those there are. */
  private static long target(MergedMesh mesh, int polygons) {
    return Math.max(0, Math.min(3L * polygons, mesh.indices().length));
  }

  /**
   * Returns the attribute weights; 0 for attributes that no vertex has, since every weighted
   * attribute costs time.
   */
  private static float[] weights(MergedMesh mesh, float normal) {
    float color = mesh.has(MergedMesh.COLOR, MergedMesh.TEX_COORD) ? COLOR : 0;
    float texCoord = mesh.has(MergedMesh.TEX_COORD, MergedMesh.PART) ? TEX_COORD : 0;
    return new float[] {normal, normal, normal, color, color, color, color, texCoord, texCoord};
  }

  private static void protect(boolean[] seams, ByteBuffer locks) {
    for (int vertex = 0; vertex < seams.length; vertex++) {
      if (seams[vertex]) {
        locks.put(vertex, (byte) meshopt_SimplifyVertex_Protect);
      }
    }
  }

  /**
   * Simplifies by vertex clustering on a grid: merges vertices that are near each other, regardless
   * of connectivity and parts.
   */
  static MergedMesh cluster(MergedMesh mesh, int polygons) {
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
                  target(mesh, polygons),
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
