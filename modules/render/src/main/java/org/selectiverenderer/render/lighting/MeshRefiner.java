package org.selectiverenderer.render.lighting;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.joml.Matrix4dc;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.geometry.mesh.VertexWelder;
import org.selectiverenderer.render.mesh.RefinedMesh;

/**
 * Refines a mesh by splitting edges at their midpoints, pass by pass, until per-vertex lighting
 * looks like per-pixel lighting. An edge is split in all triangles that share it, across seams too,
 * so that no cracks open. Deterministic; the surface does not change.
 */
final class MeshRefiner {
  /**
   * The triangles that refinement may add to a mesh: a constant number plus a number per square
   * unit of its surface. More vertices would cost more than the per-pixel lighting that they save.
   */
  private static final int ADDED = 300;

  private static final int ADDED_BY_AREA = 2500;

  private static final int MOST_ADDED = 12_000;

  private static final int MOST_PASSES = 12;

  /**
   * A refinement level is kept if it has at most this share of the triangles of the next finer
   * level kept.
   */
  private static final double WORTH = 0.7;

  private final Mesh source;
  private final MidpointVertexBuffer vertices;
  private final EdgeSplitCriterion test;
  private int[] indices;
  private boolean[] fine;
  private int[] points = {};
  private int most;
  private boolean lightSplit;
  private boolean full;
  private final List<int[]> stages = new ArrayList<>();
  private final List<Double> splits = new ArrayList<>();

  /**
   * The refined mesh.
   *
   * @param staged the mesh with its coarser levels; the source alone when nothing was to be split
   * @param forLight whether point or spot lights were a reason, else only the mesh's curvature
   * @param complete whether the tolerance was met
   */
  record Result(RefinedMesh staged, boolean forLight, boolean complete) {
    Mesh mesh() {
      return staged.mesh();
    }
  }

  private MeshRefiner(Mesh source, MidpointVertexBuffer vertices, EdgeSplitCriterion test) {
    this.source = source;
    this.vertices = vertices;
    this.test = test;
    indices = source.indices();
    fine = new boolean[indices.length / 3];
  }

  /** Prepares the first split: welds vertices of equal position and computes the triangle limit. */
  private void begin() {
    VertexWelder welder =
        new VertexWelder(source.vertexCount(), source.positions(), null, null, null);
    welder.weld();
    points = welder.numbers();
    most = indices.length / 3 + (int) Math.min(MOST_ADDED, ADDED + ADDED_BY_AREA * area());
  }

  private double area() {
    double sum = 0;
    for (int i = 0; i < indices.length; i += 3) {
      double a = test.length(indices[i], indices[i + 1]);
      double b = test.length(indices[i + 1], indices[i + 2]);
      double c = test.length(indices[i + 2], indices[i]);
      double half = (a + b + c) / 2;
      sum += Math.sqrt(Math.max(0, half * (half - a) * (half - b) * (half - c)));
    }
    return sum;
  }

  /**
   * Refines triangles with normals.
   *
   * @param world the matrix from the mesh's coordinates to those of the lights and of {@code
   *     fineness}
   * @param longest the longest edge of the mesh in the world
   * @param tolerance the invisible error of the light, in 0..1
   */
  static Result refine(
      Mesh source,
      float[] normals,
      Matrix4dc world,
      CurvatureTolerance fineness,
      DiffuseLightModel field,
      double longest,
      double tolerance) {
    MidpointVertexBuffer vertices = new MidpointVertexBuffer(source, normals, world);
    EdgeSplitCriterion test =
        new EdgeSplitCriterion(vertices, fineness, field, !source.solid(), longest, tolerance);
    return new MeshRefiner(source, vertices, test).refine();
  }

  private Result refine() {
    int passes = 0;
    while (passes < MOST_PASSES && pass()) {
      passes++;
    }
    boolean complete = !test.stepped() && !(full && lightSplit);
    RefinedMesh mesh =
        passes == 0 ? RefinedMesh.of(source) : new RefinedMesh(vertices.mesh(indices), kept());
    return new Result(mesh, lightSplit, complete);
  }

  /** Returns the coarser levels that have far fewer triangles than the next finer one kept. */
  private List<RefinedMesh.Stage> kept() {
    List<RefinedMesh.Stage> kept = new ArrayList<>();
    double undivided = 0;
    int next = indices.length;
    for (int i = stages.size() - 1; i >= 0; i--) {
      undivided = Math.max(undivided, splits.get(i));
      if (stages.get(i).length <= WORTH * next) {
        next = stages.get(i).length;
        kept.add(0, new RefinedMesh.Stage(stages.get(i), undivided));
      }
    }
    return kept;
  }

  /**
   * Splits each edge that is too long once; returns false when none is, or when the triangle limit
   * is reached.
   */
  private boolean pass() {
    EdgeSet marked = marks();
    if (marked.size() == 0) {
      return false;
    }
    int after = indices.length / 3;
    double longest = 0;
    EdgeSet pairs = new EdgeSet();
    for (int i = 0; i < indices.length; i++) {
      int next = i % 3 == 2 ? i - 2 : i + 1;
      if (marked.number(points[indices[i]], points[indices[next]]) >= 0) {
        pairs.add(indices[i], indices[next]);
        longest = Math.max(longest, vertices.length(indices[i], indices[next]));
        after++;
      }
    }
    if (after > most) {
      full = true;
      return false;
    }
    pairs.close();
    stages.add(indices);
    splits.add(longest);
    int first = addMiddles(marked, pairs);
    split(pairs, first, after);
    return true;
  }

  private EdgeSet marks() {
    EdgeSet marked = new EdgeSet();
    for (int t = 0; t < fine.length; t++) {
      if (fine[t]) {
        continue;
      }
      boolean any = false;
      double size = test.size(indices[3 * t], indices[3 * t + 1], indices[3 * t + 2]);
      for (int k = 0; k < 3; k++) {
        int a = indices[3 * t + k];
        int b = indices[3 * t + (k + 1) % 3];
        EdgeSplitCriterion.Reason reason = test.edge(a, b, size);
        if (reason != EdgeSplitCriterion.Reason.NONE) {
          mark(marked, a, b);
          lightSplit |= reason == EdgeSplitCriterion.Reason.LIGHT;
          any = true;
        }
      }
      if (!any && test.inside(indices[3 * t], indices[3 * t + 1], indices[3 * t + 2])) {
        int k = longest(t);
        mark(marked, indices[3 * t + k], indices[3 * t + (k + 1) % 3]);
        lightSplit = true;
        any = true;
      }
      fine[t] = !any;
    }
    marked.close();
    return marked;
  }

  private void mark(EdgeSet marked, int a, int b) {
    if (points.length == 0) {
      begin();
    }
    marked.add(points[a], points[b]);
  }

  private int longest(int t) {
    int longest = 0;
    double length = -1;
    for (int k = 0; k < 3; k++) {
      double own = test.length(indices[3 * t + k], indices[3 * t + (k + 1) % 3]);
      if (own > length) {
        length = own;
        longest = k;
      }
    }
    return longest;
  }

  /**
   * Adds a midpoint for each pair; returns the number of the first, which the others follow in
   * order.
   */
  private int addMiddles(EdgeSet marked, EdgeSet pairs) {
    int first = vertices.count();
    vertices.reserve(pairs.size());
    points = Arrays.copyOf(points, first + pairs.size());
    int[] middles = new int[marked.size()];
    Arrays.fill(middles, -1);
    for (int i = 0; i < pairs.size(); i++) {
      int made = vertices.middle(pairs.low(i), pairs.high(i));
      int edge = marked.number(points[pairs.low(i)], points[pairs.high(i)]);
      middles[edge] = middles[edge] < 0 ? made : middles[edge];
      points[made] = middles[edge];
    }
    return first;
  }

  private void split(EdgeSet pairs, int first, int after) {
    Split out = new Split(after);
    int[] middle = new int[3];
    for (int t = 0; t < fine.length; t++) {
      int from = 3 * t;
      int splits = 0;
      for (int k = 0; k < 3; k++) {
        int number = pairs.number(indices[from + k], indices[from + (k + 1) % 3]);
        middle[k] = number < 0 ? -1 : first + number;
        splits += number < 0 ? 0 : 1;
      }
      if (splits == 0) {
        out.add(indices[from], indices[from + 1], indices[from + 2], fine[t]);
      } else {
        split(from, middle, splits, out);
      }
    }
    indices = out.indices;
    fine = out.fine;
  }

  private void split(int from, int[] middle, int splits, Split out) {
    // Rotated so that the first edge is split, and if two are, the second too.
    int turn = 0;
    while (middle[turn] < 0 || (splits == 2 && middle[(turn + 1) % 3] < 0)) {
      turn++;
    }
    int a = indices[from + turn];
    int b = indices[from + (turn + 1) % 3];
    int c = indices[from + (turn + 2) % 3];
    int ab = middle[turn];
    int bc = middle[(turn + 1) % 3];
    int ca = middle[(turn + 2) % 3];
    switch (splits) {
      case 1 -> {
        out.add(a, ab, c, false);
        out.add(ab, b, c, false);
      }
      case 2 -> {
        out.add(ab, b, bc, false);
        if (test.length(a, bc) <= test.length(ab, c)) {
          out.add(a, ab, bc, false);
          out.add(a, bc, c, false);
        } else {
          out.add(a, ab, c, false);
          out.add(ab, bc, c, false);
        }
      }
      default -> {
        out.add(a, ab, ca, false);
        out.add(ab, b, bc, false);
        out.add(ca, bc, c, false);
        out.add(ab, bc, ca, false);
      }
    }
  }

  /** The triangles of the next level. */
  private static final class Split {
    final int[] indices;
    final boolean[] fine;
    private int triangles;

    Split(int count) {
      indices = new int[3 * count];
      fine = new boolean[count];
    }

    void add(int a, int b, int c, boolean known) {
      indices[3 * triangles] = a;
      indices[3 * triangles + 1] = b;
      indices[3 * triangles + 2] = c;
      fine[triangles++] = known;
    }
  }
}
