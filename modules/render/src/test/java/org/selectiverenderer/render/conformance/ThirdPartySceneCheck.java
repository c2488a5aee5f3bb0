package org.selectiverenderer.render.conformance;

import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.camera.ViewLayout;
import org.selectiverenderer.browser.loading.SceneLoader;
import org.selectiverenderer.browser.nodes.NodeFactory;
import org.selectiverenderer.render.ShadingMode;
import org.selectiverenderer.render.display.OffscreenView;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.ReadLimits;

/**
 * Loads third-party scenes, runs a hundred frames of each and draws the last one; started by hand.
 *
 * <p>Arguments: a file that lists the scenes, a line each; a file for the outcome; and {@code draw}
 * where the last frame of each is to be drawn. A line of the outcome: how it went ({@code ok, told,
 * threw, hung}), milliseconds, errors, warnings, remarks, heap in use in MB, the scene, and the
 * first messages.
 */
final class ThirdPartySceneCheck {
  private static final int FRAMES = 100;
  private static final long MOST_SECONDS = 60;
  private static final int MESSAGES = 40;

  private ThirdPartySceneCheck() {}

  /** The outcome of a scene. */
  private record Outcome(ProblemCollector problems, String trouble) {}

  public static void main(String[] args) throws Exception {
    List<String> scenes = Files.readAllLines(Path.of(args[0]));
    boolean draw = args.length > 2 && args[2].equals("draw");
    Map<String, Integer> counts = new TreeMap<>();
    ExecutorService worker = worker();
    try (BufferedWriter out = Files.newBufferedWriter(Path.of(args[1]), StandardCharsets.UTF_8)) {
      for (String scene : scenes) {
        long start = System.nanoTime();
        Future<Outcome> running = worker.submit(() -> run(Path.of(scene), draw));
        Outcome outcome;
        try {
          outcome = running.get(MOST_SECONDS, TimeUnit.SECONDS);
        } catch (TimeoutException e) {
          running.cancel(true);
          worker = worker();
          outcome = new Outcome(new ProblemCollector(), "hung");
        }
        long millis = Duration.ofNanos(System.nanoTime() - start).toMillis();
        counts.merge(write(out, scene, outcome, millis), 1, Integer::sum);
      }
    }
    worker.shutdownNow();
    System.out.println(counts);
    System.exit(0); // Whatever hung would go on.
  }

  private static ExecutorService worker() {
    return Executors.newSingleThreadExecutor(task -> new Thread(task, "foreign-scene"));
  }

  private static Outcome run(Path scene, boolean draw) {
    ProblemCollector problems = new ProblemCollector();
    try (SceneLoader loader =
        new SceneLoader(NodeCatalogue.load(), new NodeFactory(), ReadLimits.standard(), problems)) {
      World world = new World(loader.load(scene), problems);
      for (int frame = 0; frame < FRAMES; frame++) {
        world.step(frame / 30.0, (viewer, time, dt) -> {});
      }
      if (draw) {
        draw(world);
      }
      return new Outcome(problems, "");
    } catch (IOException e) {
      return new Outcome(problems, "cannot be read: " + e.getMessage());
    } catch (RuntimeException | StackOverflowError | OutOfMemoryError e) {
      StackTraceElement[] trace = e.getStackTrace();
      return new Outcome(problems, "threw " + e + (trace.length > 0 ? " at " + trace[0] : ""));
    }
  }

  private static void draw(World world) {
    try (OffscreenView view = OffscreenView.open(256, 256, 0, ViewLayout.MONO, ShadingMode.AUTO)) {
      view.draw(world);
      view.finish();
    }
  }

  private static String write(BufferedWriter out, String scene, Outcome outcome, long millis)
      throws IOException {
    List<Problem> told = outcome.problems().list();
    String kind =
        !outcome.trouble().isEmpty()
            ? outcome.trouble().split(" ")[0]
            : told.isEmpty() ? "ok" : "told";
    Runtime runtime = Runtime.getRuntime();
    out.write(
        String.format(
            Locale.ROOT,
            "%s\t%d\t%d\t%d\t%d\t%d\t%s\t%s",
            kind,
            millis,
            count(told, Problem.Severity.ERROR),
            count(told, Problem.Severity.WARNING),
            count(told, Problem.Severity.INFO),
            (runtime.totalMemory() - runtime.freeMemory()) >> 20,
            scene,
            outcome.trouble()));
    for (Problem problem : told.subList(0, Math.min(MESSAGES, told.size()))) {
      out.write("\t" + problem.severity() + " " + place(problem, scene) + problem.message());
    }
    out.newLine();
    out.flush();
    return kind;
  }

  /** Returns the line number, preceded by the file if it is not the scene's own. */
  private static String place(Problem problem, String scene) {
    String file = problem.location().file();
    return (scene.endsWith(file) ? "" : file + ":") + problem.location().line() + ": ";
  }

  private static long count(List<Problem> told, Problem.Severity severity) {
    return told.stream().filter(problem -> problem.severity() == severity).count();
  }
}
