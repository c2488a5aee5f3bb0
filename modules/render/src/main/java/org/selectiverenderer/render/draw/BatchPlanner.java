package org.selectiverenderer.render.draw;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.instance.ShapeInstance;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.render.lighting.ShapeLighting;
import org.selectiverenderer.render.mesh.MeshMerger;
import org.selectiverenderer.render.mesh.RefinedMesh;

/**
 * Decides which shapes share a batch: small shapes of equal draw state that are near each other.
 * The diffuse colours of plain lit shapes may differ; they are then stored in the batch's vertices.
 */
final class BatchPlanner {
  /**
   * The number of indices of a mesh's coarsest level above which the cost of a draw call of its own
   * is negligible beside its triangles.
   */
  private static final int MOST_OF_ONE = 3 * 512;

  /**
   * The most indices of a batch, counted at the coarsest levels. Batches are drawn front to back,
   * but not the shapes within one: with batches four times as large, 1,000 shapes took a tenth more
   * of the rasteriser's time and no less of ours.
   */
  private static final int MOST_TOGETHER = 3 * 1024;

  /** The number of indices up to which a mesh is copied for every shape that uses it. */
  private static final int ALWAYS_COPIED = 3 * 128;

  /** The most indices that all copies of one larger mesh may have together. */
  private static final int MOST_COPIED = 3 * 65_536;

  /**
   * The largest extent of a batch in multiples of its smallest shape's size, so that
   * single-precision coordinates stay exact enough.
   */
  private static final double WIDEST = 1024;

  private BatchPlanner() {}

  private record LitLook(DrawState look, boolean byVertex) {
    // Written out, as records link theirs when first called: the first frame would wait for it.
    @Override
    public boolean equals(@Nullable Object other) {
      return other instanceof LitLook one && look.equals(one.look) && byVertex == one.byVertex;
    }

    @Override
    public int hashCode() {
      return 31 * look.hashCode() + Boolean.hashCode(byVertex);
    }
  }

  /**
   * A shape that may share a batch with shapes of equal draw state.
   *
   * @param number the shape's index among the new shapes, which is also its order in a batch
   * @param staged the mesh that is drawn: the shape's own or a refined one
   */
  record Candidate(
      int number, ShapeInstance shape, RefinedMesh staged, DrawState look, ShapeLighting lighting) {
    Mesh mesh() {
      return staged.mesh();
    }

    /**
     * The number of indices that is drawn from afar. The cost of draw calls matters when many
     * shapes are in view, and then most of them are far away.
     */
    int least() {
      return staged.least();
    }
  }

  /** Returns the batches, each of two or more shapes; all other shapes are drawn by themselves. */
  static List<List<Candidate>> of(List<Candidate> candidates) {
    Map<Mesh, Integer> uses = new IdentityHashMap<>();
    candidates.forEach(candidate -> uses.merge(candidate.mesh(), 1, Integer::sum));
    Map<DrawState, DrawState> colourless = new IdentityHashMap<>(); // Equal looks are the same.
    Map<LitLook, List<Candidate>> byLook = new LinkedHashMap<>();
    for (Candidate candidate : candidates) {
      if (mergeable(candidate, uses.get(candidate.mesh()))) {
        LitLook look =
            new LitLook(
                colourless.computeIfAbsent(candidate.look(), of -> colourless(candidate)),
                candidate.lighting().byVertex(candidate.shape()));
        byLook.computeIfAbsent(look, same -> new ArrayList<>()).add(candidate);
      }
    }
    List<List<Candidate>> batches = new ArrayList<>();
    byLook.values().forEach(alike -> split(alike, batches));
    return batches;
  }

  /**
   * Returns the draw state without its diffuse colour, if the shape may be batched regardless of
   * it.
   */
  private static DrawState colourless(Candidate candidate) {
    DrawState look = candidate.look();
    if (!candidate.shape().surface().lit()
        || look.layout().normal() < 0
        || look.layout().color() >= 0
        || look.texture() != null) {
      return look;
    }
    float[] material = look.material().array().clone();
    Arrays.fill(material, 0, 3, 0);
    return look.of(new FloatArrayKey(material));
  }

  private static boolean mergeable(Candidate candidate, int uses) {
    int indices = candidate.mesh().indexCount();
    double determinant = candidate.shape().world().determinant3x3();
    // Blended shapes are drawn one by one, back to front; a moving shape may change between
    // per-vertex and per-pixel lighting.
    return !candidate.look().blended()
        && candidate.look().detail() == null
        && candidate.look().author() == null
        && candidate.mesh().fogDepth() < 0
        && candidate.lighting().settled()
        && candidate.least() <= MOST_OF_ONE
        && (indices <= ALWAYS_COPIED || (long) indices * uses <= MOST_COPIED)
        && candidate.mesh().vertexCount() <= MeshMerger.MOST_VERTICES
        && candidate.shape().world().isFinite()
        && determinant != 0
        && Double.isFinite(1 / determinant);
  }

  /**
   * Splits shapes that are too many or too far apart for one batch at the median of the longest
   * axis.
   */
  private static void split(List<Candidate> alike, List<List<Candidate>> batches) {
    if (alike.size() < 2) {
      return;
    }
    double[] box = bounds(alike);
    if (fits(alike, box)) {
      // In the order in which shapes are visited each frame, so that visible neighbours form one
      // range of the index buffer.
      batches.add(alike.stream().sorted(Comparator.comparingInt(Candidate::number)).toList());
      return;
    }
    int axis = longestAxis(box);
    List<Candidate> sorted = new ArrayList<>(alike);
    sorted.sort(Comparator.comparingDouble(candidate -> centre(candidate, axis)));
    int middle = sorted.size() / 2;
    split(sorted.subList(0, middle), batches);
    split(sorted.subList(middle, sorted.size()), batches);
  }

  private static boolean fits(List<Candidate> alike, double[] box) {
    long indices = 0;
    long vertices = 0;
    double smallest = Double.POSITIVE_INFINITY;
    for (Candidate candidate : alike) {
      indices += candidate.least();
      vertices += candidate.mesh().vertexCount();
      smallest = Math.min(smallest, size(candidate.shape().bounds()));
    }
    return indices <= MOST_TOGETHER
        && vertices <= MeshMerger.MOST_VERTICES
        && size(box) <= WIDEST * smallest;
  }

  /** Returns the bounding box of shapes: min x, y, z, max x, y, z. */
  static double[] bounds(List<Candidate> candidates) {
    double[] all = candidates.get(0).shape().bounds().clone();
    for (Candidate candidate : candidates) {
      double[] box = candidate.shape().bounds();
      for (int axis = 0; axis < 3; axis++) {
        all[axis] = Math.min(all[axis], box[axis]);
        all[axis + 3] = Math.max(all[axis + 3], box[axis + 3]);
      }
    }
    return all;
  }

  private static double size(double[] box) {
    return Math.max(Math.max(box[3] - box[0], box[4] - box[1]), box[5] - box[2]);
  }

  private static int longestAxis(double[] box) {
    int longest = 0;
    for (int axis = 1; axis < 3; axis++) {
      if (box[axis + 3] - box[axis] > box[longest + 3] - box[longest]) {
        longest = axis;
      }
    }
    return longest;
  }

  private static double centre(Candidate candidate, int axis) {
    double[] box = candidate.shape().bounds();
    return (box[axis] + box[axis + 3]) / 2;
  }
}
