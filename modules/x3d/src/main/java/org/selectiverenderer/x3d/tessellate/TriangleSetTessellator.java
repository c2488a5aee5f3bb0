package org.selectiverenderer.x3d.tessellate;

import org.selectiverenderer.geometry.mesh.Mesh;

/**
 * Tessellates the triangle and quadrilateral set nodes (X3D 4.0, 11.4.7 to 11.4.9, 11.4.13 to
 * 11.4.15, 32.4.4, 32.4.5). With {@code colorPerVertex} or {@code normalPerVertex} FALSE, each
 * triangle or quadrilateral is a face.
 */
final class TriangleSetTessellator {
  private final TessellationContext job;
  private final CoordinatePoints points;
  private final int[] stream;
  private final TriangleListBuilder triangles;
  private final FaceValidator check;
  private int faces;

  private TriangleSetTessellator(TessellationContext job, boolean indexed) {
    this.job = job;
    this.points = CoordinatePoints.of(job);
    this.stream = indexed ? job.node().ints("index") : IndexStreamRanges.identity(points.count());
    this.triangles = new TriangleListBuilder(stream, stream.length / 3);
    this.check = new FaceValidator(stream, points, 3);
  }

  static Mesh triangles(TessellationContext job) {
    return new TriangleSetTessellator(job, false).single(3);
  }

  static Mesh indexedTriangles(TessellationContext job) {
    return new TriangleSetTessellator(job, true).single(3);
  }

  static Mesh quads(TessellationContext job) {
    return new TriangleSetTessellator(job, false).single(4);
  }

  static Mesh indexedQuads(TessellationContext job) {
    return new TriangleSetTessellator(job, true).single(4);
  }

  static Mesh strips(TessellationContext job) {
    TriangleSetTessellator set = new TriangleSetTessellator(job, false);
    return set.strips(IndexStreamRanges.counted(job, "stripCount", 3, set.points.count()));
  }

  static Mesh indexedStrips(TessellationContext job) {
    TriangleSetTessellator set = new TriangleSetTessellator(job, true);
    return set.strips(IndexStreamRanges.separated(set.stream));
  }

  static Mesh fans(TessellationContext job) {
    TriangleSetTessellator set = new TriangleSetTessellator(job, false);
    return set.fans(IndexStreamRanges.counted(job, "fanCount", 3, set.points.count()));
  }

  static Mesh indexedFans(TessellationContext job) {
    TriangleSetTessellator set = new TriangleSetTessellator(job, true);
    return set.fans(IndexStreamRanges.separated(set.stream));
  }

  /** Adds consecutive faces of {@code size} points each. */
  private Mesh single(int size) {
    if (stream.length % size != 0) {
      int extra = stream.length % size;
      job.problem(
          extra == 1
              ? "has 1 extra point at its end; it is left out"
              : "has " + extra + " extra points at its end; they are left out");
    }
    PolygonTriangulator splitter = new PolygonTriangulator(points.xyz(), triangles);
    for (int i = 0; i + size <= stream.length; i += size) {
      if (check.accepts(i, i + size)) {
        splitter.split(i, i + size, faces);
      }
      faces++;
    }
    return finish();
  }

  private Mesh strips(IndexStreamRanges runs) {
    for (int run = 0; run < runs.count(); run++) {
      for (int i = runs.from(run); i + 2 < runs.to(run); i++) {
        boolean even = (i - runs.from(run)) % 2 == 0;
        add(even ? i : i + 1, even ? i + 1 : i, i + 2);
      }
    }
    return finish();
  }

  private Mesh fans(IndexStreamRanges runs) {
    for (int run = 0; run < runs.count(); run++) {
      for (int i = runs.from(run) + 1; i + 1 < runs.to(run); i++) {
        add(runs.from(run), i, i + 1);
      }
    }
    return finish();
  }

  private void add(int a, int b, int c) {
    if (check.accepts(a, b, c)) {
      triangles.add(a, b, c, faces);
    }
    faces++;
  }

  /** Builds the mesh; without normals, {@code normalPerVertex} makes it smooth (11.2.3). */
  private Mesh finish() {
    check.report(job, "face");
    double creaseAngle = job.node().bool("normalPerVertex") ? Math.PI : 0;
    return new ComposedGeometryMesher(job, points, triangles, faces)
        .composed(ComposedGeometryMesher.Indices.NONE, creaseAngle, null);
  }
}
