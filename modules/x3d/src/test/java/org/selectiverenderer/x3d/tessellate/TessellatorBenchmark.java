package org.selectiverenderer.x3d.tessellate;

import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.read.ParsedNode;

/**
 * Triangles per microsecond of an Tessellator.IndexedFaceSetTessellator of 10,000 triangles: a
 * sphere without poles.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.Throughput)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 3, time = 1)
public class TessellatorBenchmark {
  private static final int COLUMNS = 100;
  private static final int ROWS = 50;
  private static final int TRIANGLES = 2 * COLUMNS * ROWS;

  @Param({"given", "0", "0.5", "3.14"})
  public String normals;

  private final Tessellator tessellator = new Tessellator();
  private final ProblemCollector problems = new ProblemCollector();
  private NodeView sphere;

  @Setup
  public void makeSphere() {
    float[] points = new float[3 * COLUMNS * (ROWS + 1)];
    for (int i = 0; i < points.length / 3; i++) {
      double polar = Math.PI * (i / COLUMNS + 0.5) / (ROWS + 1);
      double angle = 2 * Math.PI * (i % COLUMNS) / COLUMNS;
      points[3 * i] = (float) (Math.sin(polar) * Math.cos(angle));
      points[3 * i + 1] = (float) Math.cos(polar);
      points[3 * i + 2] = (float) (Math.sin(polar) * Math.sin(angle));
    }
    int[] index = new int[4 * TRIANGLES];
    for (int quad = 0, at = 0; quad < COLUMNS * ROWS; quad++) {
      int next = quad / COLUMNS * COLUMNS + (quad + 1) % COLUMNS;
      for (int point : new int[] {quad, next, next + COLUMNS, -1}) {
        index[at++] = point;
      }
      for (int point : new int[] {quad, next + COLUMNS, quad + COLUMNS, -1}) {
        index[at++] = point;
      }
    }
    ParsedNode node =
        AbstractTessellatorTest.node(
            "IndexedFaceSet",
            "coord",
            AbstractTessellatorTest.coordinate(points),
            "coordIndex",
            index);
    if (normals.equals("given")) {
      node.put(
          node.type().indexOf("normal"), AbstractTessellatorTest.node("Normal", "vector", points));
    } else {
      node.put(node.type().indexOf("creaseAngle"), Float.valueOf(normals));
    }
    sphere = node;
  }

  @Benchmark
  @OperationsPerInvocation(TRIANGLES)
  public Mesh tessellate() {
    return tessellator.tessellate(sphere, problems).orElseThrow();
  }
}
