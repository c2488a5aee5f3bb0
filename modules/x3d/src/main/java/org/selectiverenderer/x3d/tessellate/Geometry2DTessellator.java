package org.selectiverenderer.x3d.tessellate;

import java.util.Arrays;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.x3d.catalogue.NodeView;

/**
 * Tessellates the nodes of the Geometry2D component (X3D 4.0, clause 14): shapes in the plane z = 0
 * that face +z, with circles of {@value #SLICES} segments.
 */
final class Geometry2DTessellator {
  private static final int SLICES = 64;

  private Geometry2DTessellator() {}

  /** Tessellates a Rectangle2D: 2 triangles with the whole texture. */
  static Mesh rectangle(TessellationContext job) {
    PrimitiveMeshBuilder builder = new PrimitiveMeshBuilder();
    if (job.positive("size")) {
      double x = job.node().floats("size")[0] / 2.0;
      double y = job.node().floats("size")[1] / 2.0;
      builder.quad(
          builder.vertex(-x, -y, 0, 0, 0, 1, 0, 0),
          builder.vertex(x, -y, 0, 0, 0, 1, 1, 0),
          builder.vertex(x, y, 0, 0, 0, 1, 1, 1),
          builder.vertex(-x, y, 0, 0, 0, 1, 0, 1));
    }
    return builder.mesh(job.node().bool("solid"));
  }

  /** Tessellates a Disk2D: 62 triangles, or 128 with a hole; a circle is cut out of the texture. */
  static Mesh disk(TessellationContext job) {
    double outer = job.node().number("outerRadius");
    double inner = job.node().number("innerRadius");
    PrimitiveMeshBuilder builder = new PrimitiveMeshBuilder();
    if (!job.positive("outerRadius")) {
      return builder.mesh(job.node().bool("solid"));
    }
    if (!(inner > 0 && inner < outer)) {
      if (inner != 0) {
        job.problem("has an innerRadius that is not between 0 and its outerRadius; it has no hole");
      }
      for (int i = 0; i < SLICES; i++) {
        rim(builder, outer, outer, i);
        if (i > 1) {
          builder.triangle(0, i - 1, i);
        }
      }
    } else {
      for (int i = 0; i <= SLICES; i++) {
        int near = rim(builder, inner, outer, i);
        int far = rim(builder, outer, outer, i);
        if (i > 0) {
          builder.quad(near - 2, far - 2, far, near);
        }
      }
    }
    return builder.mesh(job.node().bool("solid"));
  }

  private static int rim(PrimitiveMeshBuilder builder, double radius, double outer, int slice) {
    double x = radius * Math.cos(2 * Math.PI * slice / SLICES);
    double y = radius * Math.sin(2 * Math.PI * slice / SLICES);
    return builder.vertex(x, y, 0, 0, 0, 1, 0.5 + 0.5 * x / outer, 0.5 + 0.5 * y / outer);
  }

  /** Tessellates a TriangleSet2D; clockwise triangles are reversed, since the shape faces +z. */
  static Mesh triangles(TessellationContext job) {
    float[] points = spatial(job.node().floats("vertices"));
    int[] stream = IndexStreamRanges.identity(points.length / 9 * 3);
    TriangleListBuilder triangles = new TriangleListBuilder(stream, stream.length / 3);
    CoordinatePoints all = CoordinatePoints.of(points);
    FaceValidator check = new FaceValidator(stream, all, 3);
    for (int i = 0; i < stream.length; i += 3) {
      if (check.accepts(i, i + 3)) {
        int p = 3 * i;
        double turn =
            ((double) points[p + 3] - points[p]) * ((double) points[p + 7] - points[p + 1])
                - ((double) points[p + 4] - points[p + 1]) * ((double) points[p + 6] - points[p]);
        triangles.add(i, turn < 0 ? i + 2 : i + 1, turn < 0 ? i + 1 : i + 2, i / 3);
      }
    }
    check.report(job, "face");
    job.countDegenerate(triangles.dropDegenerate(points));
    int[] corners = triangles.points();
    VertexAttribute normals =
        new VertexAttribute(new float[] {0, 0, 1}, 3, new int[corners.length]);
    return new IndexedMeshBuilder(points, corners, normals, null, null)
        .mesh(Mesh.Primitive.TRIANGLES, job.node().bool("solid"), true);
  }

  /** Tessellates an ArcClose2D: a sector (PIE) or segment (CHORD) of a disk. */
  static Mesh arcClose(TessellationContext job) {
    NodeView node = job.node();
    PrimitiveMeshBuilder builder = new PrimitiveMeshBuilder();
    if (job.positive("radius")) {
      double radius = node.number("radius");
      double[] arc = arc(node);
      int parts = parts(arc);
      boolean pie = !node.string("closureType").equals("CHORD");
      if (pie) {
        builder.vertex(0, 0, 0, 0, 0, 1, 0.5, 0.5);
      }
      for (int i = 0; i <= parts; i++) {
        double angle = arc[0] + arc[1] * i / parts;
        double x = Math.cos(angle);
        double y = Math.sin(angle);
        int rim = builder.vertex(radius * x, radius * y, 0, 0, 0, 1, 0.5 + 0.5 * x, 0.5 + 0.5 * y);
        if (rim > 1) {
          builder.triangle(0, rim - 1, rim);
        }
      }
    }
    return builder.mesh(node.bool("solid"));
  }

  static Mesh arc(TessellationContext job) {
    return job.positive("radius") ? curve(job, arc(job.node())) : lines(job, new float[0]);
  }

  static Mesh circle(TessellationContext job) {
    double[] full = {0, 2 * Math.PI};
    return job.positive("radius") ? curve(job, full) : lines(job, new float[0]);
  }

  private static Mesh curve(TessellationContext job, double[] arc) {
    double radius = job.node().number("radius");
    int parts = parts(arc);
    float[] points = new float[3 * (parts + 1)];
    for (int i = 0; i <= parts; i++) {
      double angle = arc[0] + arc[1] * i / parts;
      points[3 * i] = (float) (radius * Math.cos(angle));
      points[3 * i + 1] = (float) (radius * Math.sin(angle));
    }
    return lines(job, points);
  }

  static Mesh polyline(TessellationContext job) {
    return lines(job, spatial(job.node().floats("lineSegments")));
  }

  static Mesh points(TessellationContext job) {
    float[] xyz = spatial(job.node().floats("point"));
    return plain(
        job, xyz, IndexStreamRanges.identity(xyz.length / 3), 1, Mesh.Primitive.POINTS, "point");
  }

  /** Returns lines from each point to the next. */
  static Mesh lines(TessellationContext job, float[] xyz) {
    int[] ends = new int[Math.max(0, 2 * (xyz.length / 3) - 2)];
    for (int i = 0; i < ends.length; i++) {
      ends[i] = (i + 1) / 2;
    }
    return plain(job, xyz, ends, 2, Mesh.Primitive.LINES, "line");
  }

  private static Mesh plain(
      TessellationContext job,
      float[] xyz,
      int[] stream,
      int size,
      Mesh.Primitive primitive,
      String what) {
    FaceValidator check = new FaceValidator(stream, CoordinatePoints.of(xyz), size);
    int[] corners = new int[stream.length];
    int kept = 0;
    for (int i = 0; i < stream.length; i += size) {
      if (check.accepts(i, i + size)) {
        System.arraycopy(stream, i, corners, kept, size);
        kept += size;
      }
    }
    check.report(job, what);
    return new IndexedMeshBuilder(xyz, Arrays.copyOf(corners, kept), null, null, null)
        .mesh(primitive, false, false);
  }

  /** Returns start and extent of an arc in radians, counter-clockwise; equal angles: a circle. */
  private static double[] arc(NodeView node) {
    double start = node.number("startAngle");
    double extent = (node.number("endAngle") - start) % (2 * Math.PI);
    if (!(Math.abs(extent) < 7) || !(Math.abs(start) < 1e6)) {
      return new double[] {0, 2 * Math.PI};
    }
    // As floats, 0 and 6.2832 are not quite a whole turn apart.
    if (extent < 1e-4) {
      extent += 2 * Math.PI;
    }
    return new double[] {start, Math.min(extent, 2 * Math.PI)};
  }

  private static int parts(double[] arc) {
    return Math.max(1, (int) Math.ceil(SLICES * arc[1] / (2 * Math.PI) - 1e-3));
  }

  private static float[] spatial(float[] plane) {
    float[] xyz = new float[plane.length / 2 * 3];
    for (int i = 0, j = 0; i + 1 < plane.length; i += 2, j += 3) {
      xyz[j] = plane[i];
      xyz[j + 1] = plane[i + 1];
    }
    return xyz;
  }
}
