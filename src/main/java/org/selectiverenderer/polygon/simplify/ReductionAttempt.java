package org.selectiverenderer.polygon.simplify;

/**
 * One way of coming near to a number of polygons. What collapsing edges leaves is not quite what it
 * was asked for: it stops early where seams are in the way, and overshoots where a piece vanishes.
 * So it is asked for other numbers too, and to go in small steps.
 */
final class ReductionAttempt {
  private static final int TRIES = 10;
  private static final double STEP = 0.85;

  private final int polygons;
  private final double scale;
  private final float[] bounds;
  private final Freedom freedom;
  private final Style style;

  private JoinedMesh nearest;

  /**
   * @param polygons how many are wanted
   * @param scale of the grid that positions are rounded to
   * @param bounds the box that no vertex may leave
   */
  ReductionAttempt(int polygons, double scale, float[] bounds, Freedom freedom, Style style) {
    this.polygons = polygons;
    this.scale = scale;
    this.bounds = bounds;
    this.freedom = freedom;
    this.style = style;
    this.nearest = new JoinedMesh(new float[0], new int[0], new int[0]);
  }

  /** The nearest found from that mesh; empty when nothing but nothing is left. */
  JoinedMesh from(JoinedMesh start) {
    JoinedMesh direct = collapse(start, polygons);
    if (direct.polygons() < polygons && !met()) {
      between(start, direct.polygons());
    }
    if (!met()) {
      inSteps(start);
    }
    return nearest;
  }

  /** Asks for more and more, then for what lies between too few and enough. */
  private void between(JoinedMesh start, int count) {
    int tooFew = polygons;
    int enough = start.polygons();
    boolean bounded = false;
    int left = count;
    for (int i = 0; i < TRIES && !met() && enough - tooFew > 1; i++) {
      int middle = (tooFew + enough) / 2;
      int ask = bounded ? middle : Math.min(middle, tooFew + Math.max(2, polygons - left));
      left = collapse(start, ask).polygons();
      if (left > polygons) {
        enough = ask;
        bounded = true;
      } else {
        tooFew = ask;
      }
    }
  }

  private void inSteps(JoinedMesh start) {
    JoinedMesh mesh = start;
    while (!met() && mesh.polygons() > polygons) {
      int before = mesh.polygons();
      mesh = collapse(mesh, Math.max(polygons, (int) (before * STEP)));
      if (mesh.polygons() >= before) {
        return;
      }
    }
  }

  private boolean met() {
    return nearest.polygons() > 0 && Simplified.near(nearest.polygons(), polygons);
  }

  private JoinedMesh collapse(JoinedMesh start, int count) {
    JoinedMesh mesh =
        EdgeCollapse.run(start, count, EdgeCollapse.ANY_ERROR, freedom, style)
            .rounded(scale, bounds);
    nearest = nearer(nearest, mesh, polygons);
    return mesh;
  }

  /** Which has a number of polygons nearer to the one wanted; an empty one is the last choice. */
  static JoinedMesh nearer(JoinedMesh a, JoinedMesh b, int polygons) {
    int ofA = Math.abs(a.polygons() - polygons);
    int ofB = Math.abs(b.polygons() - polygons);
    return a.polygons() == 0 || (b.polygons() > 0 && ofB < ofA) ? b : a;
  }
}
