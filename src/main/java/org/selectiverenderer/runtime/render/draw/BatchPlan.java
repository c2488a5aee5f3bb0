package org.selectiverenderer.runtime.render.draw;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.runtime.instance.ShapeInstance;
import org.selectiverenderer.runtime.render.light.Lighting;
import org.selectiverenderer.runtime.render.mesh.MeshMerger;
import org.selectiverenderer.runtime.render.mesh.StagedMesh;

/**
 * Decides which shapes share a batch: those of one look that are small and near each other. Of
 * plain lit shapes the diffuse colours may differ: then the batch's vertices have them.
 */
final class BatchPlan {
  /**
   * Indices of a mesh's coarsest stage beyond which a call of its own costs next to nothing beside
   * its triangles.
   */
  private static final int MOST_OF_ONE = 3 * 512;

  /**
   * Indices of a batch, of coarsest stages. Batches are drawn front to back, the shapes in one are
   * not: with four times as many, 1,000 shapes took a tenth more of the rasteriser's time and no
   * less before.
   */
  private static final int MOST_TOGETHER = 3 * 1024;

  /** Indices up to which a mesh is copied for every shape that uses it. */
  private static final int ALWAYS_COPIED = 3 * 128;

  /** Indices that the copies of one larger mesh may have together. */
  private static final int MOST_COPIED = 3 * 65_536;

  /** How far a batch reaches in sizes of its smallest shape: floats stay exact enough for that. */
  private static final double WIDEST = 1024;

  private BatchPlan() {}

  private record LitLook(DrawLook look, boolean byVertex) {}

  /**
   * A shape that may share a batch with those of an equal look.
   *
   * @param number of the shape among those that are new, the order in a batch too
   * @param staged what is drawn: the shape's own mesh or a finer one
   */
  record Candidate(
      int number, ShapeInstance shape, StagedMesh staged, DrawLook look, Lighting lighting) {
    Mesh mesh() {
      return staged.mesh();
    }

    /**
     * Indices of what is drawn of it from afar. Calls cost time where many shapes are in view, and
     * then most are far away.
     */
    int least() {
      return staged.least();
    }
  }

  /** The batches, of two shapes or more each; shapes that are in none are drawn by themselves. */
  static List<List<Candidate>> of(List<Candidate> candidates) {
    Map<Mesh, Integer> uses = new IdentityHashMap<>();
    candidates.forEach(candidate -> uses.merge(candidate.mesh(), 1, Integer::sum));
    Map<DrawLook, DrawLook> colourless = new IdentityHashMap<>(); // Equal looks are the same.
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

  /** What all shapes have in common that differ in their diffuse colours only. */
  private static DrawLook colourless(Candidate candidate) {
    DrawLook look = candidate.look();
    if (!candidate.shape().surface().lit()
        || look.layout().normal() < 0
        || look.layout().color() >= 0
        || look.texture() != null) {
      return look;
    }
    float[] material = look.material().array().clone();
    Arrays.fill(material, 0, 3, 0);
    return look.of(new Numbers(material));
  }

  private static boolean mergeable(Candidate candidate, int uses) {
    int indices = candidate.mesh().indices().length;
    double determinant = candidate.shape().world().determinant3x3();
    // Blended shapes are drawn one by one, back to front; what moves may be lit now so, now so.
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

  /** Halves what is too much or too wide for one batch along its longest side. */
  private static void split(List<Candidate> alike, List<List<Candidate>> batches) {
    if (alike.size() < 2) {
      return;
    }
    double[] box = bounds(alike);
    if (fits(alike, box)) {
      // In the order in which they are visited each frame, neighbours in the buffers are one
      // stretch.
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

  /** The box around shapes: min x, y, z, max x, y, z. */
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
