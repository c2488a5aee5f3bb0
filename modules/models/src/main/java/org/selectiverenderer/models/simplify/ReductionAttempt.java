package org.selectiverenderer.models.simplify;

/**
 * One attempt to reach a number of polygons. Edge collapse does not hit a requested number exactly:
 * it stops early where seams block it, and overshoots where a component vanishes. So other numbers
 * are requested too, and collapses run in small steps.
 */
final class ReductionAttempt {
  private static final int TRIES = 10;
  private static final double STEP = 0.85;

  private final int polygons;
  private final double scale;
  private final float[] bounds;
  private final TopologyConstraint freedom;
  private final SimplificationPreset style;

  private MergedMesh nearest;

  /**
   * @param polygons the number of polygons wanted
   * @param scale steps per unit of length of the grid that positions are rounded to
   * @param bounds the bounding box that no vertex may leave
   */
  ReductionAttempt(
      int polygons,
      double scale,
      float[] bounds,
      TopologyConstraint freedom,
      SimplificationPreset style) {
    this.polygons = polygons;
    this.scale = scale;
    this.bounds = bounds;
    this.freedom = freedom;
    this.style = style;
    this.nearest = new MergedMesh(new float[0], new int[0], new int[0]);
  }

  /**
   * Returns the mesh with the nearest number of polygons found from a start mesh; empty when all
   * results are empty.
   */
  MergedMesh from(MergedMesh start) {
    MergedMesh direct = collapse(start, polygons);
    if (direct.polygons() < polygons && !met()) {
      between(start, direct.polygons());
    }
    if (!met()) {
      inSteps(start);
    }
    return nearest;
  }

  /** Requests increasing numbers, then bisects between too few and enough. */
  private void between(MergedMesh start, int count) {
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

  private void inSteps(MergedMesh start) {
    MergedMesh mesh = start;
    while (!met() && mesh.polygons() > polygons) {
      int before = mesh.polygons();
      mesh = collapse(mesh, Math.max(polygons, (int) (before * STEP)));
      if (mesh.polygons() >= before) {
        return;
      }
    }
  }

  private boolean met() {
    return nearest.polygons() > 0 && SimplificationResult.near(nearest.polygons(), polygons);
  }

  private MergedMesh collapse(MergedMesh start, int count) {
    MergedMesh mesh =
        EdgeCollapse.run(start, count, EdgeCollapse.ANY_ERROR, freedom, style)
            .rounded(scale, bounds);
    nearest = nearer(nearest, mesh, polygons);
    return mesh;
  }

  /**
   * Returns the mesh whose number of polygons is nearer to the one wanted; an empty one only if
   * both are empty.
   */
  static MergedMesh nearer(MergedMesh a, MergedMesh b, int polygons) {
    int ofA = Math.abs(a.polygons() - polygons);
    int ofB = Math.abs(b.polygons() - polygons);
    return a.polygons() == 0 || (b.polygons() > 0 && ofB < ofA) ? b : a;
  }
}
