package org.selectiverenderer.polygon.simplify;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.selectiverenderer.polygon.simplify.EdgeCollapse.Outcome;
import org.selectiverenderer.x3d.geometry.Mesh;

/**
 * Reduces the polygons of models. All parts of a model are reduced together, so that its error is
 * spread evenly: a part whose form can do without gives more polygons than one that cannot. Edges
 * where materials, colours or texture coordinates change are kept as long as the goal can be met
 * with them.
 *
 * <p>Immutable; several threads may use one, each on its own model. The same model and goal give
 * the same result every time.
 */
public final class Simplifier {
  private static final int VERTEX_TRIES = 8;

  /**
   * Reduces a model.
   *
   * @param parts its triangles; all in one coordinate frame
   * @throws IllegalArgumentException if a part is not made of triangles, an index is out of range
   *     or a number not finite, there is no triangle with an area, or the goal is no less than what
   *     the model has
   */
  public Simplified simplify(List<Mesh> parts, Goal goal) {
    JoinedMesh original = JoinedMesh.of(parts).compact().asOriginal();
    if (original.polygons() == 0) {
      throw new IllegalArgumentException("the model has no polygons");
    }
    Reduction reduction = new Reduction(original);
    if (goal instanceof Goal.Polygons polygons) {
      check(polygons.count(), original.polygons(), "polygons");
      Outcome outcome = reduction.to(polygons.count());
      return result(
          parts, original, outcome, Simplified.near(outcome.mesh().polygons(), polygons.count()));
    }
    if (goal instanceof Goal.LargestError largest) {
      Outcome outcome = reduction.within(largest.error());
      return result(parts, original, outcome, outcome.error() <= largest.error());
    }
    int has = Seams.positions(original);
    int wanted =
        goal instanceof Goal.Vertices vertices
            ? vertices.count()
            : (int) Math.round(has * ((Goal.VertexPercent) goal).percent() / 100);
    check(wanted, has, "vertices");
    return toVertices(parts, original, reduction, has, Math.max(1, wanted));
  }

  private static void check(int wanted, int has, String what) {
    if (wanted > has) {
      throw new IllegalArgumentException(
          "the model has only %d %s, fewer than %d".formatted(has, what, wanted));
    }
  }

  /** A collapse takes a vertex and, where the surface is closed, two polygons. */
  private static Simplified toVertices(
      List<Mesh> parts, JoinedMesh original, Reduction reduction, int has, int wanted) {
    Outcome best = new Outcome(original, 0);
    int nearest = has;
    int polygons = original.polygons();
    int vertices = has;
    for (int i = 0; i < VERTEX_TRIES && !Simplified.near(nearest, wanted); i++) {
      int ask = Math.max(1, polygons - 2 * (vertices - wanted));
      if (i > 0 && ask == polygons) {
        break;
      }
      polygons = ask;
      Outcome outcome = reduction.to(Math.min(ask, original.polygons()));
      vertices = Seams.positions(outcome.mesh());
      if (Math.abs(vertices - wanted) < Math.abs(nearest - wanted)) {
        best = outcome;
        nearest = vertices;
      }
    }
    return result(parts, original, best, Simplified.near(nearest, wanted));
  }

  private static Simplified result(
      List<Mesh> parts, JoinedMesh original, Outcome outcome, boolean met) {
    JoinedMesh reduced = outcome.mesh();
    int[][] triangles = byPart(reduced, parts.size());
    float[] bounds = Mesh.boundsOf(positions(original), original.indices());
    CornerNormals corners = new CornerNormals(original);
    List<Mesh> meshes = new ArrayList<>();
    for (int p = 0; p < triangles.length; p++) {
      meshes.add(
          new PartMaker(parts.get(p), original, reduced, corners).mesh(triangles[p], bounds));
    }
    return new Simplified(
        List.copyOf(meshes), Seams.positions(reduced), reduced.polygons(), outcome.error(), met);
  }

  private static float[] positions(JoinedMesh mesh) {
    float[] positions = new float[3 * mesh.vertexCount()];
    for (int v = 0; v < mesh.vertexCount(); v++) {
      System.arraycopy(mesh.vertices(), JoinedMesh.STRIDE * v, positions, 3 * v, 3);
    }
    return positions;
  }

  /** The triangles of each part: a triangle belongs to the part of most of its vertices. */
  private static int[][] byPart(JoinedMesh mesh, int parts) {
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
