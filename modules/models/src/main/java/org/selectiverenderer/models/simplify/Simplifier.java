package org.selectiverenderer.models.simplify;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.selectiverenderer.base.natives.LwjglLibraries;
import org.selectiverenderer.geometry.mesh.Mesh;

/**
 * Reduces the polygons of models. All parts of a model are simplified together, so that the error
 * is spread evenly: flat parts lose more polygons than curved ones. Edges where materials, colours
 * or texture coordinates change are preserved as long as the target can be met with them.
 *
 * <p>Immutable and thread-safe. The same model and target give the same result every time.
 */
public final class Simplifier {
  private static final int ERROR_TRIES = 12;
  private static final double ALL_GONE = 0.6;

  private static final int COUNT_TRIES = 9;

  /** The search for the smallest number of polygons ends when the bounds are within this factor. */
  private static final double CLOSE_COUNT = 1.05;

  /** An error of at least this share of the allowed one ends the search. */
  private static final double CLOSE = 0.8;

  /**
   * Reduces a model.
   *
   * @param parts triangle meshes of the parts, all in one coordinate frame
   * @throws EmptyModelException if every triangle is degenerate or tiny relative to the model's
   *     extent
   * @throws IllegalArgumentException if a part is not made of triangles, an index is out of range
   *     or a number not finite, or the target is not less than what the model has
   */
  public SimplificationResult simplify(List<Mesh> parts, SimplificationTarget goal) {
    LwjglLibraries.use(Simplifier.class, LwjglLibraries.Part.MESHOPTIMIZER);
    MergedMesh joined = MergedMesh.of(parts);
    MergedMesh original =
        joined.welded(ReductionSearch.scale(joined.extent())).compact().asOriginal();
    if (original.polygons() == 0) {
      throw new EmptyModelException();
    }
    ReductionSearch reduction = new ReductionSearch(original);
    if (goal instanceof SimplificationTarget.Polygons polygons) {
      check(polygons.count(), original.polygons(), "polygons");
      MergedMesh reduced = reduction.to(polygons.count());
      if (!SimplificationResult.near(reduced.polygons(), polygons.count())) {
        reduced = reduction.exactly(polygons.count());
      }
      return result(
          parts,
          reduction,
          reduced,
          SimplificationResult.near(reduced.polygons(), polygons.count()));
    }
    if (goal instanceof SimplificationTarget.Exactly exactly) {
      check(exactly.count(), original.polygons(), "polygons");
      MergedMesh reduced = reduction.exactly(exactly.count());
      return result(parts, reduction, reduced, reduced.polygons() == exactly.count());
    }
    if (goal instanceof SimplificationTarget.LargestError largest) {
      return within(parts, reduction, largest.error());
    }
    int has = PositionRemap.positions(original);
    int wanted =
        goal instanceof SimplificationTarget.Vertices vertices
            ? vertices.count()
            : (int) Math.round(has * ((SimplificationTarget.VertexPercent) goal).percent() / 100);
    check(wanted, has, "vertices");
    MergedMesh reduced = has <= wanted ? original : reduction.toPositions(Math.max(1, wanted), has);
    return result(
        parts,
        reduction,
        reduced,
        SimplificationResult.near(PositionRemap.positions(reduced), wanted));
  }

  private static void check(int wanted, int has, String what) {
    if (wanted > has) {
      throw new IllegalArgumentException(
          "the model has only %d %s, fewer than %d".formatted(has, what, wanted));
    }
  }

  /**
   * Simplifies within an error. The error estimate of edge collapse is not a bound, so the
   * deviation of each result is measured. It tries one style only, whereas a target number of
   * polygons tries several, so that a smaller number may have as small an error.
   */
  private static SimplificationResult within(
      List<Mesh> parts, ReductionSearch reduction, double largest) {
    SimplificationResult best = result(parts, reduction, reduction.original(), true);
    double allowed = largest;
    for (int i = 0; i < ERROR_TRIES; i++) {
      MergedMesh reduced = reduction.within(allowed);
      if (reduced.polygons() == 0) {
        allowed *= ALL_GONE;
        continue;
      }
      SimplificationResult result = result(parts, reduction, reduced, true);
      if (result.error() <= largest && result.polygons() < best.polygons()) {
        best = result;
      }
      if (result.error() <= largest && result.error() >= CLOSE * largest) {
        break;
      }
      double factor = largest / Math.max(result.error(), 1e-12);
      allowed *= Math.max(0.3, Math.min(3, 0.95 * factor));
    }
    return fewer(parts, reduction, largest, best);
  }

  /**
   * Returns the result with the fewest polygons within an error, searched between no polygons and a
   * known result.
   */
  private static SimplificationResult fewer(
      List<Mesh> parts, ReductionSearch reduction, double largest, SimplificationResult enough) {
    SimplificationResult best = enough;
    int tooFew = 1;
    for (int i = 0; i < COUNT_TRIES && best.polygons() > CLOSE_COUNT * tooFew; i++) {
      int ask = (int) Math.sqrt((double) tooFew * best.polygons());
      SimplificationResult result = result(parts, reduction, reduction.to(ask), true);
      if (result.error() <= largest && result.polygons() < best.polygons()) {
        best = result;
      } else {
        tooFew = Math.max(tooFew + 1, ask);
      }
    }
    return best;
  }

  private static SimplificationResult result(
      List<Mesh> parts, ReductionSearch reduction, MergedMesh found, boolean met) {
    MergedMesh original = reduction.original();
    MergedMesh reduced = reduction.fitted(found);
    int[][] triangles = byPart(reduced, parts.size());
    CornerNormals corners = new CornerNormals(original);
    int[] own = new int[reduced.vertexCount()];
    Arrays.fill(own, -1);
    List<Mesh> meshes = new ArrayList<>();
    for (int p = 0; p < triangles.length; p++) {
      meshes.add(
          new PartMeshBuilder(parts.get(p), original, reduced, corners, own).mesh(triangles[p]));
    }
    return new SimplificationResult(
        List.copyOf(meshes),
        PositionRemap.positions(reduced),
        reduced.polygons(),
        reduced == original ? 0 : new MeshDeviation(original).error(reduced),
        met);
  }

  /** Returns the triangles of each part; a triangle belongs to the part of most of its vertices. */
  private static int[][] byPart(MergedMesh mesh, int parts) {
    int[] counts = new int[parts];
    int[] partOf = new int[mesh.polygons()];
    for (int t = 0; t < partOf.length; t++) {
      int a = mesh.part(mesh.indices()[3 * t]);
      int b = mesh.part(mesh.indices()[3 * t + 1]);
      int c = mesh.part(mesh.indices()[3 * t + 2]);
      partOf[t] = b == c ? b : a;
      counts[partOf[t]]++;
    }
    int[][] triangles = new int[parts][];
    Arrays.setAll(triangles, part -> new int[counts[part]]);
    for (int t = partOf.length - 1; t >= 0; t--) {
      triangles[partOf[t]][--counts[partOf[t]]] = t;
    }
    return triangles;
  }
}
