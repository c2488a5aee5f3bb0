package org.selectiverenderer.polygon.simplify;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.DoubleStream;
import org.selectiverenderer.geometry.mesh.Mesh;

/**
 * Finds the reduction with a wanted number of polygons: with no more freedom than that takes, and
 * of several styles the one that looks most like the original.
 */
final class Reduction {
  /** How many polygons clusters get for each one wanted: the more, the more careful the rest. */
  private static final double[] CLUSTERED = {3, 1.5, 1};

  private static final int LOWER_TRIES = 6;

  private static final int POSITION_TRIES = 9;

  /** Up to so many polygons all styles are tried and compared. */
  private static final int COMPARED = 25_000;

  /** A model larger than this is brought to so many times the polygons wanted first. */
  private static final int LARGE = 5_000;

  private static final int AHEAD = 4;

  /** A part that has gone is not made good for by stretching the rest. */
  private static final double LARGEST_STRETCH = 1.1;

  private final JoinedMesh original;
  private final Likeness likeness;
  private final double scale;
  private final float[] bounds;

  /**
   * @param original without vertices that no triangle uses: they would count as seams
   */
  Reduction(JoinedMesh original) {
    this.original = original;
    this.likeness = new Likeness(original);
    this.scale = scale(original.extent());
    this.bounds = Mesh.boundsOf(original.positions(), original.indices());
  }

  JoinedMesh original() {
    return original;
  }

  /** The mesh nearest to that number of polygons, and of those the most like; never empty. */
  JoinedMesh to(int polygons) {
    if (original.polygons() <= polygons) {
      return original;
    }
    JoinedMesh base = base(polygons);
    boolean compare = base.polygons() <= COMPARED;
    List<JoinedMesh> found = new ArrayList<>();
    JoinedMesh best = original;
    JoinedMesh fewest = original;
    for (Freedom freedom : Freedom.values()) {
      if (!found.isEmpty() && (!compare || freedom.compareTo(Freedom.ANY_PIECE) > 0)) {
        break;
      }
      for (JoinedMesh start : starts(freedom, base, fewest, polygons)) {
        best = ReductionAttempt.nearer(best, start, polygons);
        for (Style style : compare ? Style.values() : new Style[] {Style.BALANCED}) {
          JoinedMesh mesh =
              new ReductionAttempt(polygons, scale, bounds, freedom, style).from(start);
          best = ReductionAttempt.nearer(best, mesh, polygons);
          if (mesh.polygons() >= polygons && mesh.polygons() < fewest.polygons()) {
            fewest = mesh;
          }
          if (mesh.polygons() > 0 && Simplified.near(mesh.polygons(), polygons)) {
            found.add(mesh);
          }
        }
      }
    }
    return found.isEmpty() ? best : mostLike(found);
  }

  /**
   * A mesh with that number of polygons: from the nearest reduction that has no more, edges are
   * split. Where that cannot be, the nearest.
   */
  JoinedMesh exactly(int polygons) {
    JoinedMesh nearest = to(polygons);
    JoinedMesh reduced = nearest;
    int ask = polygons;
    for (int i = 0; i < LOWER_TRIES && reduced.polygons() > polygons && ask > 1; i++) {
      ask = Math.max(1, ask - (reduced.polygons() - polygons));
      reduced = to(ask);
    }
    return reduced.polygons() > polygons
        ? nearest
        : ReductionAttempt.nearer(nearest, EdgeSplits.upTo(polygons, reduced, scale), polygons);
  }

  /**
   * A reduced mesh as high, wide and deep as the original: few polygons cut the corners of what is
   * round, and an object that has become smaller would float above what it stands on, and be seen
   * to jump when its version changes.
   */
  JoinedMesh fitted(JoinedMesh reduced) {
    return reduced == original ? reduced : reduced.fitted(bounds, LARGEST_STRETCH, scale);
  }

  private JoinedMesh base(int polygons) {
    long ahead = (long) AHEAD * polygons;
    if (original.polygons() <= LARGE || ahead >= Math.min(original.polygons(), COMPARED)) {
      return original;
    }
    JoinedMesh base =
        EdgeCollapse.run(
                original,
                AHEAD * polygons,
                EdgeCollapse.ANY_ERROR,
                Freedom.KEEP_SEAMS,
                Style.BALANCED)
            .rounded(scale, bounds);
    return base.polygons() > polygons ? base : original;
  }

  /**
   * A mesh with about that number of positions: of the counts of polygons that have been tried, the
   * one between them is tried next; what is missing in the end comes from splitting edges.
   *
   * @param has the positions of the original
   */
  JoinedMesh toPositions(int wanted, int has) {
    int few = 0;
    int many = original.polygons();
    double ofFew = 0;
    double ofMany = has;
    JoinedMesh below = null;
    for (int i = 0; i < POSITION_TRIES && many - few > 1; i++) {
      // By proportion at first; every third time the middle, which never gets stuck.
      double share = i % 3 == 2 ? 0.5 : (wanted - ofFew) / (ofMany - ofFew);
      int ask = few + (int) Math.round(share * (many - few));
      ask = Math.max(few + 1, Math.min(many - 1, ask));
      JoinedMesh mesh = to(ask);
      int positions = Seams.positions(mesh);
      if (Simplified.near(positions, wanted)) {
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
        : EdgeSplits.withMore(wanted - Seams.positions(below), below, scale);
  }

  /**
   * Where to start from.
   *
   * @param fewest the mesh with fewest polygons, but enough of them, so far
   */
  private List<JoinedMesh> starts(
      Freedom freedom, JoinedMesh base, JoinedMesh fewest, int polygons) {
    return switch (freedom) {
      case KEEP_SEAMS, ANY_EDGE, ANY_PIECE -> List.of(base);
      case FEWER_PIECES -> List.of(Pieces.withoutSmallest(fewest, polygons));
      case ANY_SURFACE ->
          DoubleStream.of(CLUSTERED)
              .mapToObj(share -> clustered((int) Math.ceil(share * polygons)))
              .toList();
    };
  }

  private JoinedMesh clustered(int polygons) {
    return EdgeCollapse.cluster(original, Math.min(polygons, original.polygons()))
        .rounded(scale, bounds);
  }

  private JoinedMesh mostLike(List<JoinedMesh> meshes) {
    JoinedMesh best = meshes.get(0);
    double least = Double.POSITIVE_INFINITY;
    for (JoinedMesh mesh : meshes.size() == 1 ? List.<JoinedMesh>of() : meshes) {
      double difference = likeness.difference(mesh);
      if (difference < least) {
        least = difference;
        best = mesh;
      }
    }
    return best;
  }

  /** The largest reduction with about that error, as a share of the extent; it may be empty. */
  JoinedMesh within(double error) {
    return EdgeCollapse.run(original, 1, (float) error, Freedom.KEEP_SEAMS, Style.BALANCED)
        .rounded(scale, bounds);
  }

  /**
   * Steps per unit of length that leave a model's largest side five digits: so short are the
   * numbers in its file, and what the file holds is what has been counted.
   */
  static double scale(double extent) {
    return extent > 0 ? Math.pow(10, 4 - Math.floor(Math.log10(extent))) : 1;
  }
}
