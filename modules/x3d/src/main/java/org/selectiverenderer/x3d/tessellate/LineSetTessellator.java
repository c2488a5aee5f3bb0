package org.selectiverenderer.x3d.tessellate;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.mesh.Mesh;

/**
 * Converts IndexedLineSet, LineSet and PointSet nodes to unlit meshes (X3D 4.0, 11.4.3, 11.4.5,
 * 11.4.11).
 */
final class LineSetTessellator {
  private final TessellationContext job;
  private final CoordinatePoints points;
  private final int[] stream;
  private int[] positions = new int[64];
  private int[] runOf = new int[64];
  private int count;

  private LineSetTessellator(TessellationContext job, int @Nullable [] stream) {
    this.job = job;
    this.points = CoordinatePoints.of(job);
    this.stream = stream == null ? IndexStreamRanges.identity(points.count()) : stream;
  }

  static Mesh indexedLines(TessellationContext job) {
    LineSetTessellator set = new LineSetTessellator(job, job.node().ints("coordIndex"));
    set.segments(IndexStreamRanges.separated(set.stream));
    boolean perVertex = job.node().bool("colorPerVertex");
    return set.mesh(Mesh.Primitive.LINES, perVertex, job.node().ints("colorIndex"));
  }

  static Mesh lines(TessellationContext job) {
    LineSetTessellator set = new LineSetTessellator(job, null);
    set.segments(IndexStreamRanges.counted(job, "vertexCount", 2, set.points.count()));
    return set.mesh(Mesh.Primitive.LINES, true, new int[0]);
  }

  static Mesh points(TessellationContext job) {
    LineSetTessellator set = new LineSetTessellator(job, null);
    FaceValidator check = new FaceValidator(set.stream, set.points, 1);
    for (int i = 0; i < set.stream.length; i++) {
      if (check.accepts(i, i + 1)) {
        set.add(i, i);
      }
    }
    check.report(job, "point");
    return set.mesh(Mesh.Primitive.POINTS, true, new int[0]);
  }

  private void segments(IndexStreamRanges runs) {
    FaceValidator check = new FaceValidator(stream, points, 2);
    for (int run = 0; run < runs.count(); run++) {
      // ranges with too small a vertexCount are empty and have been reported
      if (runs.to(run) > runs.from(run) && check.accepts(runs.from(run), runs.to(run))) {
        for (int i = runs.from(run); i + 1 < runs.to(run); i++) {
          add(i, run);
          add(i + 1, run);
        }
      }
    }
    check.report(job, "line");
  }

  private void add(int position, int run) {
    if (count == positions.length) {
      positions = Arrays.copyOf(positions, 2 * count);
      runOf = Arrays.copyOf(runOf, 2 * count);
    }
    positions[count] = position;
    runOf[count++] = run;
  }

  private Mesh mesh(Mesh.Primitive primitive, boolean colorPerVertex, int[] colorIndex) {
    int[] corners = new int[count];
    for (int i = 0; i < count; i++) {
      corners[i] = stream[positions[i]];
    }
    VertexAttribute colors = colors(corners, colorPerVertex, colorIndex);
    return new IndexedMeshBuilder(
            points.xyz(), corners, null, colors, null, ShaderVertexAttributes.of(job, corners, 0))
        .mesh(primitive, false, false);
  }

  private @Nullable VertexAttribute colors(int[] corners, boolean perVertex, int[] index) {
    float[] values = GeometryPropertyReader.colors(job);
    if (values == null) {
      return null;
    }
    int[] ids = new int[count];
    for (int i = 0; i < count; i++) {
      int own = perVertex ? positions[i] : runOf[i];
      int id;
      if (index.length == 0) {
        id = perVertex ? corners[i] : own;
      } else {
        id = own < index.length ? index[own] : -1;
      }
      if (id < 0 || id >= values.length / 4) {
        job.problem("has too few colors for its points; they are left out");
        return null;
      }
      ids[i] = id;
    }
    return new VertexAttribute(values, 4, ids);
  }
}
