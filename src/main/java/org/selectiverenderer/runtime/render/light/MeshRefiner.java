package org.selectiverenderer.runtime.render.light;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.joml.Matrix4dc;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.geometry.mesh.ValueWelder;
import org.selectiverenderer.runtime.render.mesh.StagedMesh;

/**
 * Splits the edges of a mesh in their middles, pass by pass, until light at its vertices is as good
 * as light by pixel. An edge is split with all triangles that share it, seams included, so that no
 * cracks open. Deterministic; what is on the surface stays on it.
 */
final class MeshRefiner {
  /**
   * Triangles that refinement may add to a mesh: so many, and so many for each square unit of its
   * surface. More vertices cost more than the pixels that they spare.
   */
  private static final int ADDED = 300;

  private static final int ADDED_BY_AREA = 2500;

  private static final int MOST_ADDED = 12_000;

  private static final int MOST_PASSES = 12;

  /** Of the triangles of the next stage kept, how many a stage may have at most to be kept too. */
  private static final double WORTH = 0.7;

  private final Mesh source;
  private final FineVertices vertices;
  private final EdgeTest test;
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
   * @param staged with the stages before; of the source itself alone when nothing was to be split
   * @param forLight whether lights with a place were a reason, else only the mesh itself
   * @param complete whether the light by vertex is as good as was asked for
   */
  record Result(StagedMesh staged, boolean forLight, boolean complete) {
    Mesh mesh() {
      return staged.mesh();
    }
  }

  private MeshRefiner(Mesh source, FineVertices vertices, EdgeTest test) {
    this.source = source;
    this.vertices = vertices;
    this.test = test;
    indices = source.indices();
    fine = new boolean[indices.length / 3];
  }

  /**
   * What only meshes take that are split: the numbers of their points, and how far they may grow.
   */
  private void begin() {
    ValueWelder welder =
        new ValueWelder(source.vertexCount(), source.positions(), null, null, null);
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
   * @param world from the mesh's coordinates to those of the lights and of {@code fineness}
   * @param longest edge of the mesh in the world
   * @param tolerance departures of the light, in 0..1, that nobody sees
   */
  static Result refine(
      Mesh source,
      float[] normals,
      Matrix4dc world,
      Fineness fineness,
      LightField field,
      double longest,
      double tolerance) {
    FineVertices vertices = new FineVertices(source, normals, world);
    EdgeTest test = new EdgeTest(vertices, fineness, field, !source.solid(), longest, tolerance);
    return new MeshRefiner(source, vertices, test).refine();
  }

  private Result refine() {
    int passes = 0;
    while (passes < MOST_PASSES && pass()) {
      passes++;
    }
    boolean complete = !test.stepped() && !(full && lightSplit);
    StagedMesh mesh =
        passes == 0 ? StagedMesh.of(source) : new StagedMesh(vertices.mesh(indices), kept());
    return new Result(mesh, lightSplit, complete);
  }

  /** The stages before the last one that have far fewer triangles than those after them. */
  private List<StagedMesh.Stage> kept() {
    List<StagedMesh.Stage> kept = new ArrayList<>();
    double undivided = 0;
    int next = indices.length;
    for (int i = stages.size() - 1; i >= 0; i--) {
      undivided = Math.max(undivided, splits.get(i));
      if (stages.get(i).length <= WORTH * next) {
        next = stages.get(i).length;
        kept.add(0, new StagedMesh.Stage(stages.get(i), undivided));
      }
    }
    return kept;
  }

  /** Splits what is too coarse once; false when nothing is, or when there is no room. */
  private boolean pass() {
    EdgeMarks marked = marks();
    if (marked.size() == 0) {
      return false;
    }
    int after = indices.length / 3;
    double longest = 0;
    EdgeMarks pairs = new EdgeMarks();
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

  private EdgeMarks marks() {
    EdgeMarks marked = new EdgeMarks();
    for (int t = 0; t < fine.length; t++) {
      if (fine[t]) {
        continue;
      }
      boolean any = false;
      double size = test.size(indices[3 * t], indices[3 * t + 1], indices[3 * t + 2]);
      for (int k = 0; k < 3; k++) {
        int a = indices[3 * t + k];
        int b = indices[3 * t + (k + 1) % 3];
        EdgeTest.Reason reason = test.edge(a, b, size);
        if (reason != EdgeTest.Reason.NONE) {
          mark(marked, a, b);
          lightSplit |= reason == EdgeTest.Reason.LIGHT;
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

  private void mark(EdgeMarks marked, int a, int b) {
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

  /** The number of the first of the new vertices, which follow one another as the pairs do. */
  private int addMiddles(EdgeMarks marked, EdgeMarks pairs) {
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

  private void split(EdgeMarks pairs, int first, int after) {
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
    // Turned so that its first edge is split, and of two its second too.
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

  /** Triangles in the making. */
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
