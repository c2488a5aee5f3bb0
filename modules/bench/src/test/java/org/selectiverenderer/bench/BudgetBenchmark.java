package org.selectiverenderer.bench;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import org.joml.Vector3d;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;
import org.selectiverenderer.browser.viewer.Viewer;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.control.budget.MultipleChoiceKnapsack;
import org.selectiverenderer.control.budget.RenderingBudget;
import org.selectiverenderer.control.budget.VersionChoices;
import org.selectiverenderer.control.budget.VersionLoss;
import org.selectiverenderer.walkthrough.Walkthrough;

/**
 * Microseconds of a frame for the best versions of 10,000 objects within a budget, as the viewer
 * walks through them at 1.4 m/s with 60 frames a second and looks around: the solution alone,
 * weights and solution, the whole step of a walkthrough with the budget, and the step without.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
public class BudgetBenchmark {
  private static final int OBJECTS = 10_000;
  private static final int ROW = 100;
  private static final long[] TRIANGLES = {12, 240, 1200};

  /** Metres from one object to the next. */
  private static final double APART = 2;

  private static final double SPEED = 1.4;
  private static final double RATE = 60;

  private final double[] x = new double[OBJECTS];
  private final double[] z = new double[OBJECTS];
  private final MultipleChoiceKnapsack problem = problem();
  private final long budget = OBJECTS * TRIANGLES[2] / 4;
  private Path folder;
  private Walkthrough kept;
  private Walkthrough free;
  private long frame;

  /** The solution of a problem of as many objects, with three versions each. */
  private static MultipleChoiceKnapsack problem() {
    Random random = new Random(1);
    List<VersionChoices> items = new ArrayList<>();
    for (int i = 0; i < OBJECTS; i++) {
      List<Long> costs = new ArrayList<>();
      List<Double> losses = new ArrayList<>();
      for (long triangles : TRIANGLES) {
        long cost = Math.round(triangles * (0.5 + random.nextDouble()));
        costs.add(cost);
        losses.add(VersionLoss.ofTriangles(cost));
      }
      items.add(new VersionChoices(costs, losses));
    }
    return new MultipleChoiceKnapsack(items, 0.25);
  }

  @Setup
  public void makeScene() throws IOException {
    StringBuilder scene = new StringBuilder("<X3D version='4.0' profile='Full'><Scene>");
    for (int i = 0; i < OBJECTS; i++) {
      x[i] = APART * (i % ROW - ROW / 2.0);
      z[i] = APART * (i / ROW - ROW / 2.0);
      scene.append("<Transform translation='%s 0 %s'>".formatted(x[i], z[i]));
      scene.append("<Switch DEF='O%d' whichChoice='2'>".formatted(i));
      for (int version = 0; version < TRIANGLES.length; version++) {
        if (i == 0) {
          scene.append("<Group DEF='V%d'>".formatted(version));
          scene.append("<Shape><Box/></Shape>".repeat((int) TRIANGLES[version] / 12));
          scene.append("</Group>");
        } else {
          scene.append("<Group USE='V%d'/>".formatted(version));
        }
      }
      scene.append("<MetadataSet containerField='metadata'>");
      for (double degree : new double[] {1, 0.5, 0}) {
        scene.append(
            "<MetadataSet><MetadataString name='degreeOfConsistency' value='\"%s\"'/>"
                .formatted(degree));
        scene.append("<MetadataString name='schemaBelonginess' value='\"S\"'/></MetadataSet>");
      }
      scene.append("</MetadataSet></Switch></Transform>");
    }
    folder = Files.createTempDirectory("budget");
    Path file = Files.writeString(folder.resolve("scene.x3d"), scene.append("</Scene></X3D>"));
    free = open(file, SelectiveController.Settings.SELECTIVE);
    kept =
        open(
            file,
            SelectiveController.Settings.SELECTIVE.within(
                new RenderingBudget(RenderingBudget.Unit.TRIANGLES, budget)));
  }

  private static Walkthrough open(Path file, SelectiveController.Settings settings)
      throws IOException {
    return Walkthrough.open(file, settings, problem -> {}, event -> {}, text -> {});
  }

  @TearDown
  public void close() throws IOException {
    kept.close();
    free.close();
    Files.delete(folder.resolve("scene.x3d"));
    Files.delete(folder);
  }

  /** The viewer's way: there and back along the middle row. */
  private double at() {
    double way = frame * SPEED / RATE;
    double length = APART * ROW;
    double along = way % (2 * length);
    return (along < length ? along : 2 * length - along) - length / 2;
  }

  @Benchmark
  public long solution() {
    problem.solve(budget + (frame++ & 1));
    return problem.cost();
  }

  @Benchmark
  public long weightsAndSolution() {
    frame++;
    double eye = at();
    for (int i = 0; i < OBJECTS; i++) {
      double dx = x[i] - eye;
      double dz = z[i] - 0.3;
      double distance = Math.sqrt(dx * dx + dz * dz);
      problem.weigh(i, VersionLoss.sizeInView(0.5, distance));
    }
    problem.solve(budget);
    return problem.cost();
  }

  @Benchmark
  public long stepWithBudget() {
    return step(kept);
  }

  @Benchmark
  public long stepWithoutBudget() {
    return step(free);
  }

  private long step(Walkthrough walk) {
    frame++;
    double eye = at();
    double yaw = 0.5 * Math.sin(frame / RATE);
    walk.step(
        frame / RATE,
        (viewer, now, dt) -> {
          viewer.moveTo(new Vector3d(eye, 0, 0.3));
          viewer.turnTo(Viewer.orientation(yaw, 0, 0));
        });
    return walk.polygons();
  }
}
