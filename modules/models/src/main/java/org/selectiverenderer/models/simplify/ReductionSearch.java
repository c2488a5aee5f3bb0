package org.selectiverenderer.models.simplify;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.DoubleStream;
import org.selectiverenderer.geometry.mesh.Mesh;

/**
 * Searches the reduction with a wanted number of polygons: under the strictest {@link
 * TopologyConstraint} that reaches it, and among several {@link SimplificationPreset}s the result
 * with the least visible difference from the original.
 */
final class ReductionSearch {
  /**
   * Polygons left after vertex clustering, as multiples of the number wanted; the more, the more is
   * left to careful edge collapses.
   */
  private static final double[] CLUSTERED = {3, 1.5, 1};

  private static final int LOWER_TRIES = 6;

  private static final int POSITION_TRIES = 9;

  /** Up to this many polygons, all styles are tried and compared. */
  private static final int COMPARED = 25_000;

  /**
   * A model with more polygons than this is first reduced to {@link #AHEAD} times the number
   * wanted.
   */
  private static final int LARGE = 5_000;

  private static final int AHEAD = 4;

  /**
   * The largest stretch factor: a part that has vanished must not be compensated by stretching the
   * rest.
   */
  private static final double LARGEST_STRETCH = 1.1;

  private final MergedMesh original;
  private final MeshDeviation likeness;
  private final double scale;
  private final float[] bounds;

  /**
   * @param original the original mesh without unused vertices, which would count as seams
   */
  ReductionSearch(MergedMesh original) {
    this.original = original;
    this.likeness = new MeshDeviation(original);
    this.scale = scale(original.extent());
    this.bounds = Mesh.boundsOf(original.positions(), original.indices());
  }

  MergedMesh original() {
    return original;
  }

  /**
   * Returns the mesh nearest to that number of polygons, and among equally near ones the one with
   * the least visible difference; never empty.
   */
  MergedMesh to(int polygons) {
    if (original.polygons() <= polygons) {
      return original;
    }
    MergedMesh base = base(polygons);
    boolean compare = base.polygons() <= COMPARED;
    List<MergedMesh> found = new ArrayList<>();
    MergedMesh best = original;
    MergedMesh fewest = original;
    for (TopologyConstraint freedom : TopologyConstraint.values()) {
      if (!found.isEmpty() && (!compare || freedom.compareTo(TopologyConstraint.ANY_PIECE) > 0)) {
        break;
      }
      for (MergedMesh start : starts(freedom, base, fewest, polygons)) {
        best = ReductionAttempt.nearer(best, start, polygons);
        for (SimplificationPreset style :
            compare
                ? SimplificationPreset.values()
                : new SimplificationPreset[] {SimplificationPreset.BALANCED}) {
          MergedMesh mesh =
              new ReductionAttempt(polygons, scale, bounds, freedom, style).from(start);
          best = ReductionAttempt.nearer(best, mesh, polygons);
          if (mesh.polygons() >= polygons && mesh.polygons() < fewest.polygons()) {
            fewest = mesh;
          }
          if (mesh.polygons() > 0 && SimplificationResult.near(mesh.polygons(), polygons)) {
            found.add(mesh);
          }
        }
      }
    }
    return found.isEmpty() ? best : mostLike(found);
  }

  /**
   * Returns a mesh with exactly that number of polygons, by edge splits of the nearest reduction
   * that has no more; where that is impossible, the nearest mesh.
   */
  MergedMesh exactly(int polygons) {
    MergedMesh nearest = to(polygons);
    MergedMesh reduced = nearest;
    int ask = polygons;
    for (int i = 0; i < LOWER_TRIES && reduced.polygons() > polygons && ask > 1; i++) {
      ask = Math.max(1, ask - (reduced.polygons() - polygons));
      reduced = to(ask);
    }
    return reduced.polygons() > polygons
        ? nearest
        : ReductionAttempt.nearer(
            nearest, EdgeSplitRefiner.upTo(polygons, reduced, scale), polygons);
  }

  /**
   * Returns a reduced mesh stretched to the bounding box of the original: with few polygons, round
   * shapes shrink, so that an object would float above its support and visibly jump when its
   * version changes.
   */
  MergedMesh fitted(MergedMesh reduced) {
    return reduced == original ? reduced : reduced.fitted(bounds, LARGEST_STRETCH, scale);
  }

  private MergedMesh base(int polygons) {
    long ahead = (long) AHEAD * polygons;
    if (original.polygons() <= LARGE || ahead >= Math.min(original.polygons(), COMPARED)) {
      return original;
    }
    MergedMesh base =
        EdgeCollapse.run(
                original,
                AHEAD * polygons,
                EdgeCollapse.ANY_ERROR,
                TopologyConstraint.KEEP_SEAMS,
                SimplificationPreset.BALANCED)
            .rounded(scale, bounds);
    return base.polygons() > polygons ? base : original;
  }

  /**
   * Returns a mesh with about that number of positions, by a bracketing search over polygon counts;
   * positions that are missing in the end are added by edge splits.
   *
   * @param has number of positions of the original
   */
  MergedMesh toPositions(int wanted, int has) {
    int few = 0;
    int many = original.polygons();
    double ofFew = 0;
    double ofMany = has;
    MergedMesh below = null;
    for (int i = 0; i < POSITION_TRIES && many - few > 1; i++) {
      // Interpolates (regula falsi), with a bisection step every third time so that the search
      // cannot stall.
      double share = i % 3 == 2 ? 0.5 : (wanted - ofFew) / (ofMany - ofFew);
      int ask = few + (int) Math.round(share * (many - few));
      ask = Math.max(few + 1, Math.min(many - 1, ask));
      MergedMesh mesh = to(ask);
      int positions = PositionRemap.positions(mesh);
      if (SimplificationResult.near(positions, wanted)) {
        return mesh;
      }
      if (positions > wanted) {
        many = ask;
        ofMany = positions;
      } else {
        few = ask;
        ofFew = positions;
        below = mesh;
      }
    }
    return below == null
        ? to(many)
        : EdgeSplitRefiner.withMore(wanted - PositionRemap.positions(below), below, scale);
  }

  /**
   * Returns the meshes from which collapses start.
   *
   * @param fewest the mesh with the fewest polygons so far that still has enough
   */
  private List<MergedMesh> starts(
      TopologyConstraint freedom, MergedMesh base, MergedMesh fewest, int polygons) {
    return switch (freedom) {
      case KEEP_SEAMS, ANY_EDGE, ANY_PIECE -> List.of(base);
      case FEWER_PIECES -> List.of(ConnectedComponents.withoutSmallest(fewest, polygons));
      case ANY_SURFACE ->
          DoubleStream.of(CLUSTERED)
              .mapToObj(share -> clustered((int) Math.ceil(share * polygons)))
              .toList();
    };
  }

  private MergedMesh clustered(int polygons) {
    return EdgeCollapse.cluster(original, Math.min(polygons, original.polygons()))
        .rounded(scale, bounds);
  }

  private MergedMesh mostLike(List<MergedMesh> meshes) {
    MergedMesh best = meshes.get(0);
    double least = Double.POSITIVE_INFINITY;
    for (MergedMesh mesh : meshes.size() == 1 ? List.<MergedMesh>of() : meshes) {
      double difference = likeness.difference(mesh);
      if (difference < least) {
        least = difference;
        best = mesh;
      }
    }
    return best;
  }

  /**
   * Returns the reduction with fewest polygons within about that error, as a share of the extent;
   * it may be empty.
   */
  MergedMesh within(double error) {
    return EdgeCollapse.run(
            original,
            1,
            (float) error,
            TopologyConstraint.KEEP_SEAMS,
            SimplificationPreset.BALANCED)
        .rounded(scale, bounds);
  }

  /**
   * Returns the grid steps per unit of length that leave five digits for a model's largest side:
   * the numbers in its file are that short, and the counts are those of the rounded mesh in the
   * file.
   */
  static double scale(double extent) {
    return extent > 0 ? Math.pow(10, 4 - Math.floor(Math.log10(extent))) : 1;
  }
}
