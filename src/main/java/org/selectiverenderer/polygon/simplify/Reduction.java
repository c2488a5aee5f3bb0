package org.selectiverenderer.polygon.simplify;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Finds the reduction with a wanted number of polygons. Collapsing edges may stop early, where the
 * seams of a model stand in its way, or overshoot, where a small piece vanishes as a whole; so more
 * freedom is given, or other numbers are asked for, until the number comes out.
 */
final class Reduction {
  private static final int TRIES = 12;

  /** How many polygons clusters get for each one wanted, to be reduced with care from there. */
  private static final int CLUSTERED = 3;

  /** Up to so many polygons all styles are tried and compared. */
  private static final int COMPARED = 60_000;

  private final JoinedMesh original;
  private final Likeness likeness;
  private final double scale;

  /**
   * @param original without vertices that no triangle uses: they would count as seams
   */
  Reduction(JoinedMesh original) {
    this.original = original;
    this.likeness = new Likeness(original);
    this.scale = scale(original.extent());
  }

  /** The mesh nearest to that number of polygons, and of those the most like; never empty. */
  JoinedMesh to(int polygons) {
    if (Simplified.near(original.polygons(), polygons)) {
      return original;
    }
    boolean compare = original.polygons() <= COMPARED;
    List<JoinedMesh> found = new ArrayList<>();
    JoinedMesh best = original;
    for (Freedom freedom : Freedom.values()) {
      if (!found.isEmpty() && (!compare || freedom == Freedom.ANY_SURFACE)) {
        break;
      }
      JoinedMesh start = freedom == Freedom.ANY_SURFACE ? clustered(polygons) : original;
      for (Style style : compare ? Style.values() : new Style[] {Style.BALANCED}) {
        JoinedMesh mesh = approach(start, polygons, freedom, style);
        best = nearer(best, mesh, polygons);
        if (mesh.polygons() > 0 && Simplified.near(mesh.polygons(), polygons)) {
          found.add(mesh);
        }
      }
    }
    return found.isEmpty() ? best : mostLike(found);
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

  private JoinedMesh clustered(int polygons) {
    return clean(
        EdgeCollapse.cluster(original, Math.min(CLUSTERED * polygons, original.polygons())));
  }

  /** Asks for more and more, then for what lies between, as long as too few are left. */
  private JoinedMesh approach(JoinedMesh start, int polygons, Freedom freedom, Style style) {
    JoinedMesh best = null;
    JoinedMesh above = start;
    int tooFew = 0;
    int enough = start.polygons();
    int ask = polygons;
    for (int i = 0; i < TRIES && ask > tooFew && ask < enough; i++) {
      JoinedMesh mesh = collapse(start, ask, freedom, style);
      int count = mesh.polygons();
      best = nearer(best, mesh, polygons);
      if (Simplified.near(count, polygons)) {
        return mesh;
      }
      if (count > polygons) {
        above = mesh;
        enough = ask;
        if (ask == polygons) {
          break; // The structure allows no fewer.
        }
      } else {
        tooFew = ask;
      }
      int between = (tooFew + enough) / 2;
      ask = above == start ? Math.min(between, tooFew + Math.max(2, polygons - count)) : between;
    }
    if (above != start && above.polygons() > polygons && tooFew > 0) {
      // From another start the steps fall elsewhere.
      best = nearer(best, collapse(above, polygons, freedom, style), polygons);
    }
    return best == null ? start : best;
  }

  private JoinedMesh collapse(JoinedMesh start, int polygons, Freedom freedom, Style style) {
    return clean(EdgeCollapse.run(start, polygons, EdgeCollapse.ANY_ERROR, freedom, style));
  }

  /** The largest reduction with about that error, as a share of the extent. */
  JoinedMesh within(double error) {
    JoinedMesh mesh =
        clean(EdgeCollapse.run(original, 1, (float) error, Freedom.KEEP_SEAMS, Style.BALANCED));
    return mesh.polygons() > 0 ? mesh : to(1);
  }

  private JoinedMesh clean(JoinedMesh mesh) {
    return Areas.dropEmpty(mesh.rounded(scale)).compact();
  }

  /**
   * Steps per unit of length that leave a model's largest side five digits: so short are the
   * numbers in its file, and what the file holds is what has been counted.
   */
  static double scale(double extent) {
    return extent > 0 ? Math.pow(10, 4 - Math.floor(Math.log10(extent))) : 1;
  }

  private static JoinedMesh nearer(@Nullable JoinedMesh a, JoinedMesh b, int polygons) {
    if (a == null || a.polygons() == 0) {
      return b;
    }
    int ofA = Math.abs(a.polygons() - polygons);
    int ofB = Math.abs(b.polygons() - polygons);
    return b.polygons() > 0 && ofB < ofA ? b : a;
  }
}
