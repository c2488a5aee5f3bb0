package org.selectiverenderer.polygon.simplify;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.polygon.simplify.EdgeCollapse.Outcome;

/**
 * Finds the reduction with a wanted number of polygons. Collapsing edges may stop early, where the
 * seams of a model stand in its way, or overshoot, where a small piece vanishes as a whole; so more
 * freedom is given, or other numbers are asked for, until the number comes out.
 */
final class Reduction {
  private static final int TRIES = 12;

  /** How many polygons clusters get for each one wanted, to be reduced with care from there. */
  private static final int CLUSTERED = 3;

  private final JoinedMesh original;
  private final double scale;

  /**
   * @param original without vertices that no triangle uses: they would count as seams
   */
  Reduction(JoinedMesh original) {
    this.original = original;
    this.scale = scale(original.extent());
  }

  /** The outcome nearest to that number of polygons; never without any. */
  Outcome to(int polygons) {
    Outcome best = new Outcome(original, 0);
    for (Freedom freedom : Freedom.values()) {
      if (Simplified.near(best.mesh().polygons(), polygons)) {
        break;
      }
      Outcome start =
          freedom == Freedom.ANY_SURFACE ? clustered(polygons) : new Outcome(original, 0);
      best = nearer(best, approach(start, polygons, freedom), polygons);
    }
    return best;
  }

  private Outcome clustered(int polygons) {
    int count = Math.min(CLUSTERED * polygons, original.polygons());
    return clean(EdgeCollapse.cluster(original, count), 0);
  }

  /** Asks for more and more, then for what lies between, as long as too few are left. */
  private Outcome approach(Outcome start, int polygons, Freedom freedom) {
    Outcome best = null;
    Outcome above = start;
    int tooFew = 0;
    int enough = start.mesh().polygons();
    int ask = polygons;
    for (int i = 0; i < TRIES && ask > tooFew && ask < enough; i++) {
      Outcome outcome = collapse(start, ask, freedom);
      int count = outcome.mesh().polygons();
      best = nearer(best, outcome, polygons);
      if (Simplified.near(count, polygons)) {
        return best;
      }
      if (count > polygons) {
        above = outcome;
        enough = ask;
        if (ask == polygons) {
          break; // The structure allows no fewer.
        }
      } else {
        tooFew = ask;
      }
      ask =
          above == start
              ? Math.min((tooFew + enough) / 2, tooFew + Math.max(2, polygons - count))
              : (tooFew + enough) / 2;
    }
    if (above != start && above.mesh().polygons() > polygons && tooFew > 0) {
      // From another start the steps fall elsewhere.
      best = nearer(best, collapse(above, polygons, freedom), polygons);
    }
    return best == null ? start : best;
  }

  private Outcome collapse(Outcome start, int polygons, Freedom freedom) {
    return clean(
        EdgeCollapse.run(start.mesh(), polygons, EdgeCollapse.ANY_ERROR, freedom), start.error());
  }

  /** The largest reduction with at most that error, as a share of the extent. */
  Outcome within(double error) {
    Outcome outcome = clean(EdgeCollapse.run(original, 1, (float) error, Freedom.KEEP_SEAMS), 0);
    return outcome.mesh().polygons() > 0 ? outcome : to(1);
  }

  private Outcome clean(Outcome outcome, double before) {
    JoinedMesh rounded = outcome.mesh().rounded(scale);
    return new Outcome(Areas.dropEmpty(rounded).compact(), outcome.error() + before);
  }

  /**
   * Steps per unit of length that leave a model's largest side five digits: so short are the
   * numbers in its file, and what the file holds is what has been counted.
   */
  static double scale(double extent) {
    return extent > 0 ? Math.pow(10, 4 - Math.floor(Math.log10(extent))) : 1;
  }

  private static Outcome nearer(@Nullable Outcome a, Outcome b, int polygons) {
    if (a == null || a.mesh().polygons() == 0) {
      return b;
    }
    int ofA = Math.abs(a.mesh().polygons() - polygons);
    int ofB = Math.abs(b.mesh().polygons() - polygons);
    return b.mesh().polygons() > 0 && ofB < ofA ? b : a;
  }
}
