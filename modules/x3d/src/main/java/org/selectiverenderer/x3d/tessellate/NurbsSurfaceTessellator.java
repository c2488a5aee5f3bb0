package org.selectiverenderer.x3d.tessellate;

import java.util.Optional;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.geometry.nurbs.NurbsSurface;
import org.selectiverenderer.x3d.catalogue.NodeView;

/**
 * Tessellates NurbsPatchSurface and NurbsTrimmedSurface nodes (X3D 4.0, 27.4.11, 27.4.15) evenly in
 * both parameters, with normals and texture coordinates evaluated at every vertex. On the front, u,
 * v and the normal form a right-handed system.
 */
final class NurbsSurfaceTessellator {
  /** The maximum number of grid cells of a surface. */
  private static final int MAX_CELLS = 250_000;

  private final NurbsSurface surface;
  private final @Nullable NurbsSurface texture;
  private final PrimitiveMeshBuilder builder = new PrimitiveMeshBuilder();

  private NurbsSurfaceTessellator(NurbsSurface surface, @Nullable NurbsSurface texture) {
    this.surface = surface;
    this.texture = texture;
  }

  static Mesh patch(TessellationContext job) {
    return mesh(job, false);
  }

  static Mesh trimmed(TessellationContext job) {
    return mesh(job, !job.node().nodes("trimmingContour").isEmpty());
  }

  private static Mesh mesh(TessellationContext job, boolean trimmed) {
    NodeView node = job.node();
    boolean solid = node.bool("solid");
    Optional<NurbsSurface> found = NurbsNodeReader.surface(node, job::problem);
    if (found.isEmpty()) {
      return PrimitiveMeshBuilder.empty(solid);
    }
    NurbsSurface surface = found.get();
    NurbsSurfaceTessellator made = new NurbsSurfaceTessellator(surface, texture(job, surface));
    int columns = NurbsNodeReader.parts(node.integer("uTessellation"), surface.u().count());
    int rows = NurbsNodeReader.parts(node.integer("vTessellation"), surface.v().count());
    if ((long) columns * rows > MAX_CELLS) {
      double share = Math.sqrt((double) MAX_CELLS / columns / rows);
      columns = Math.max(1, (int) (columns * share));
      rows = Math.max(1, MAX_CELLS / columns);
      job.problem("asks for too many parts; it is divided into %d x %d".formatted(columns, rows));
    }
    double[] us = surface.u().parameters(columns);
    double[] vs = surface.v().parameters(rows);
    if (trimmed) {
      new TrimmedSurfaceTriangulator(us, vs)
          .fill(TrimmingLoops.of(node.nodes("trimmingContour"), job), made::vertex, made::triangle);
    } else {
      made.grid(us, vs);
    }
    Mesh mesh = made.builder.mesh(solid);
    return DegenerateTriangleFilter.without(mesh, job);
  }

  private void grid(double[] us, double[] vs) {
    for (int row = 0; row < vs.length; row++) {
      for (int column = 0; column < us.length; column++) {
        int at = vertex(us[column], vs[row]);
        if (row > 0 && column > 0) {
          int below = at - us.length;
          builder.quad(below - 1, below, at, at - 1);
        }
      }
    }
  }

  private void triangle(int a, int b, int c) {
    builder.triangle(a, b, c);
  }

  private int vertex(double u, double v) {
    double[] at = surface.at(u, v);
    Vector3d normal = normal(at);
    if (!(normal.lengthSquared() > 0.5)) {
      // at a degenerate edge, collapsed to a point, take the normal slightly inside the surface
      double insideU = u + 1e-4 * (surface.u().at(0.5) - u);
      double insideV = v + 1e-4 * (surface.v().at(0.5) - v);
      normal = normal(surface.at(insideU, insideV));
    }
    if (!(normal.lengthSquared() > 0.5)) {
      normal.set(0, 0, 1);
    }
    double s = (u - surface.u().from()) / (surface.u().to() - surface.u().from());
    double t = (v - surface.v().from()) / (surface.v().to() - surface.v().from());
    if (texture != null) {
      double[] st = texture.at(texture.u().at(s), texture.v().at(t));
      s = st[0];
      t = st[1];
    }
    return builder.vertex(at[0], at[1], at[2], normal.x, normal.y, normal.z, s, t);
  }

  private static Vector3d normal(double[] at) {
    Vector3d byU = new Vector3d(at[3], at[4], at[5]);
    Vector3d byV = new Vector3d(at[6], at[7], at[8]);
    double scale = byU.length() * byV.length();
    Vector3d normal = byU.cross(byV);
    return normal.length() > 1e-9 * scale && scale > 0 ? normal.normalize() : normal.zero();
  }

  /** Returns the texture coordinates as a surface: a node of their own or one per control point. */
  private static @Nullable NurbsSurface texture(TessellationContext job, NurbsSurface surface) {
    NodeView given = job.node().node("texCoord");
    if (given == null) {
      return null;
    }
    if (given.type().name().equals("NurbsTextureCoordinate")) {
      return NurbsNodeReader.surface(given, job::problem).orElse(null);
    }
    float[] points = GeometryPropertyReader.texCoords(job);
    if (points == null) {
      return null;
    }
    if (points.length / 2 < surface.weights().length) {
      job.problem("has too few texture coordinates; default texture coordinates are used");
      return null;
    }
    double[] weighted = NurbsNodeReader.doubles(points);
    for (int i = 0; i < 2 * surface.weights().length; i++) {
      weighted[i] *= surface.weights()[i / 2];
    }
    return new NurbsSurface(surface.u(), surface.v(), weighted, 2, surface.weights());
  }
}
