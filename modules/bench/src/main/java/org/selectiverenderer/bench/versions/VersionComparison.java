package org.selectiverenderer.bench.versions;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import org.selectiverenderer.base.decimal.DecimalRounding;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.camera.ViewLayout;
import org.selectiverenderer.browser.viewer.CameraPath;
import org.selectiverenderer.browser.viewer.CameraPathReader;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.control.budget.RenderingBudget;
import org.selectiverenderer.render.ShadingMode;
import org.selectiverenderer.render.display.OffscreenView;
import org.selectiverenderer.walkthrough.budget.ObjectPlaces;

/**
 * Compares rules for the choice of versions at equal budgets: at some poses of a path, pictures of
 * the versions that each rule chooses are compared with the picture of all objects high.
 *
 * <p>The budgets are those of the thesis's rule, which has none to set: what it shows at each pose;
 * and shares of what the versions of all objects differ in.
 */
public final class VersionComparison {
  private static final double RATE = 10;
  private static final int WIDTH = 640;
  private static final int HEIGHT = 480;
  private static final double[] SHARES = {0.02, 0.05, 0.1, 0.2, 0.4};

  private final int poses;
  private final Consumer<String> progress;

  /**
   * @param poses number of poses at which pictures are compared, at least 1
   * @param progress receives a line for each pose
   */
  public VersionComparison(int poses, Consumer<String> progress) {
    this.poses = poses;
    this.progress = progress;
  }

  /** Triangles and unlikeness of several pictures. */
  private static final class Sum {
    private double triangles;
    private double unlike;
    private int count;

    void add(long shown, double similarity) {
      triangles += shown;
      unlike += 1 - similarity;
      count++;
    }

    void put(ObjectNode node) {
      node.put("triangles", Math.round(triangles / count));
      node.put("unlike", DecimalRounding.to(5, unlike / count));
    }
  }

  /** A frame holds the versions that the thesis's rule shows. */
  private record ThesisFrame(double time, long triangles, int[] choices) {}

  /**
   * Measures one scene.
   *
   * @param scene with enriched objects
   * @param path through the scene
   * @throws IOException if a file cannot be read
   */
  public void measure(Path scene, Path path, ObjectNode node) throws IOException {
    CameraPath way =
        CameraPathReader.read(path, new ProblemCollector())
            .orElseThrow(() -> new IOException(path + " has no path"));
    List<ThesisFrame> compared = compared(thesis(scene, way));
    Map<VersionRule, List<Sum>> sums = new EnumMap<>(VersionRule.class);
    Map<VersionRule, Sum> equal = new EnumMap<>(VersionRule.class);
    for (VersionRule rule : VersionRule.values()) {
      sums.put(rule, IntStream.range(0, SHARES.length).mapToObj(i -> new Sum()).toList());
      equal.put(rule, new Sum());
    }
    Sum thesis = new Sum();
    long high = 0;
    RenderingBudget chosen = new RenderingBudget(RenderingBudget.Unit.TRIANGLES, 1);
    try (ControlledWorld live =
            new ControlledWorld(scene, way, SelectiveController.Settings.SELECTIVE.within(chosen));
        OffscreenView view =
            OffscreenView.open(WIDTH, HEIGHT, 0, ViewLayout.MONO, ShadingMode.AUTO)) {
      live.step(way.start());
      Map<VersionRule, ObjectPlaces> places = new EnumMap<>(VersionRule.class);
      for (VersionRule rule : VersionRule.values()) {
        places.put(rule, live.places());
      }
      double time = way.start();
      for (ThesisFrame frame : compared) {
        progress.accept(String.format(Locale.ROOT, "pictures at %.1f s", frame.time()));
        while (time < frame.time() - 1e-9) {
          time = Math.min(frame.time(), time + 1 / RATE);
          live.step(time);
        }
        Pictures pictures = new Pictures(live, view, places.get(VersionRule.DISTANCE));
        high = pictures.highTriangles();
        pictures.add(frame.choices(), thesis);
        for (VersionRule rule : VersionRule.values()) {
          for (int share = 0; share < SHARES.length; share++) {
            pictures.add(rule, places.get(rule), pictures.budget(SHARES[share]), sums, share);
          }
          long budget = frame.triangles() - pictures.fixed();
          pictures.add(rule.choose(places.get(rule), live.world.viewer(), budget), equal.get(rule));
        }
      }
    }
    node.put("poses", compared.size());
    node.put("width", WIDTH);
    node.put("height", HEIGHT);
    node.put("triangles_high", high);
    thesis.put(node.putObject("thesis"));
    ObjectNode same = node.putObject("at_the_thesis_triangles");
    ObjectNode rules = node.putObject("rules");
    sums.forEach(
        (rule, all) -> {
          equal.get(rule).put(same.putObject(rule.label()));
          ArrayNode rows = rules.putArray(rule.label());
          all.forEach(sum -> sum.put(rows.addObject()));
        });
  }

  private static List<ThesisFrame> thesis(Path scene, CameraPath way) throws IOException {
    List<ThesisFrame> frames = new ArrayList<>();
    try (ControlledWorld live =
        new ControlledWorld(scene, way, SelectiveController.Settings.SELECTIVE)) {
      for (int frame = 0; way.start() + frame / RATE <= way.end(); frame++) {
        double time = way.start() + frame / RATE;
        live.step(time);
        frames.add(new ThesisFrame(time, live.world.shownPolygons(), live.choices()));
      }
    }
    return frames;
  }

  /** Returns poses spread evenly over the frames. */
  private List<ThesisFrame> compared(List<ThesisFrame> frames) {
    int count = Math.min(poses, frames.size());
    return IntStream.range(0, count)
        .mapToObj(i -> frames.get((2 * i + 1) * frames.size() / (2 * count)))
        .toList();
  }

  /** The pictures of one pose. */
  private static final class Pictures {
    private final ControlledWorld live;
    private final OffscreenView view;
    private final double[] high;
    private final long highTriangles;
    private final long fixed;
    private final long least;
    private final long most;

    Pictures(ControlledWorld live, OffscreenView view, ObjectPlaces places) {
      this.live = live;
      this.view = view;
      int[] finest = VersionRule.DISTANCE.choose(places, live.world.viewer(), Long.MAX_VALUE);
      int[] coarsest = VersionRule.DISTANCE.choose(places, live.world.viewer(), 0);
      most = VersionRule.cost(places, finest);
      least = VersionRule.cost(places, coarsest);
      high = picture(finest);
      highTriangles = live.world.shownPolygons();
      fixed = highTriangles - most;
    }

    /** Returns the triangles of a share of what the objects' versions differ in. */
    long budget(double share) {
      return least + Math.round(share * (most - least));
    }

    long fixed() {
      return fixed;
    }

    long highTriangles() {
      return highTriangles;
    }

    void add(
        VersionRule rule,
        ObjectPlaces places,
        long budget,
        Map<VersionRule, List<Sum>> sums,
        int share) {
      add(rule.choose(places, live.world.viewer(), budget), sums.get(rule).get(share));
    }

    void add(int[] versions, Sum to) {
      double[] grey = picture(versions);
      to.add(live.world.shownPolygons(), StructuralSimilarity.of(high, grey, WIDTH));
    }

    private double[] picture(int[] versions) {
      live.show(versions);
      view.draw(live.world);
      view.finish();
      return StructuralSimilarity.grey(view.screenshot().rgba());
    }
  }
}
