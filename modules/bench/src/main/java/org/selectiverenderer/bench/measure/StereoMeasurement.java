package org.selectiverenderer.bench.measure;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.apparatus.DisplayProfile;
import org.selectiverenderer.apparatus.EyeGeometry;
import org.selectiverenderer.base.decimal.DecimalRounding;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.bench.BenchScene;
import org.selectiverenderer.browser.camera.ViewLayout;
import org.selectiverenderer.browser.viewer.CameraPath;
import org.selectiverenderer.browser.viewer.CameraPathReader;
import org.selectiverenderer.browser.viewer.PathMotion;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.hmd.StereoLayout;
import org.selectiverenderer.render.ShadingMode;
import org.selectiverenderer.render.display.OffscreenView;
import org.selectiverenderer.walkthrough.Walkthrough;

/**
 * Measures the cost of the second eye: the frames of one eye and of both eyes, update and drawing,
 * on the same walk through the same scene. Rounds of both kinds alternate, so that other load of
 * the machine affects both, and neighbouring rounds are compared. This is done with pictures of the
 * display's size, and with pictures so small that the fill rate does not matter and only triangles
 * and draw calls count.
 *
 * <p>{@code second_eye_to_first} should stay below 1.6: it is the time that the second eye adds,
 * divided by the time of a frame of one eye.
 */
final class StereoMeasurement {
  private static final int ROUNDS = 7;
  private static final int FRAMES = 30;
  private static final double RATE = 30;

  /** The factor by which a small picture is narrower and lower than the display's. */
  private static final int SMALLER = 8;

  private StereoMeasurement() {}

  /** Measures both sizes of pictures. */
  static void measure(BenchScene scene, DisplayProfile profile, ObjectNode node)
      throws IOException {
    pictures(scene, profile, profile.width(), profile.height(), node);
    pictures(
        scene,
        profile,
        profile.width() / SMALLER,
        profile.height() / SMALLER,
        node.putObject("small_pictures"));
  }

  private static void pictures(
      BenchScene scene, DisplayProfile profile, int width, int height, ObjectNode node)
      throws IOException {
    StereoLayout both =
        new StereoLayout(
            new EyeGeometry(profile, EyeGeometry.MEAN_IPD / 1000),
            StereoLayout.Arrangement.SIDE_BY_SIDE);
    ViewLayout one =
        (world, wide, high, range) -> List.of(both.views(world, 2 * wide, high, range).get(0));
    Optional<CameraPath> path = CameraPathReader.read(scene.path(), new ProblemCollector());
    if (path.isEmpty()) {
      throw new IOException("the benchmark's path is broken");
    }
    double[] single = new double[ROUNDS];
    double[] twice = new double[ROUNDS];
    double[] second = new double[ROUNDS];
    try (Walkthrough walk =
        Walkthrough.open(
            scene.scene(),
            SelectiveController.Settings.SELECTIVE,
            problem -> {},
            event -> {},
            text -> {})) {
      double time = 0;
      for (int round = -1; round < ROUNDS; round++) { // The first warms up.
        double singleMs = frames(walk, path.get(), width, height, one, time);
        double twiceMs = frames(walk, path.get(), 2 * width, height, both, time + FRAMES / RATE);
        time += 2 * FRAMES / RATE;
        if (round >= 0) {
          single[round] = singleMs;
          twice[round] = twiceMs;
          second[round] = (twiceMs - singleMs) / singleMs;
        }
      }
    }
    node.put("eye_width", width);
    node.put("eye_height", height);
    node.put("one_eye_ms", DecimalRounding.to(2, Medians.median(single)));
    node.put("both_eyes_ms", DecimalRounding.to(2, Medians.median(twice)));
    node.put("second_eye_to_first", DecimalRounding.to(2, Medians.median(second)));
  }

  /** Returns the milliseconds per frame. */
  private static double frames(
      Walkthrough walk, CameraPath path, int width, int height, ViewLayout layout, double start)
      throws IOException {
    try (OffscreenView view = OffscreenView.open(width, height, 0, layout, ShadingMode.AUTO)) {
      view.prepare(walk.world());
      // Each round walks the same way.
      PathMotion motion = new PathMotion(path, start - path.start());
      walk.step(start, motion);
      view.draw(walk.world());
      view.finish();
      long begun = System.nanoTime();
      for (int frame = 1; frame <= FRAMES; frame++) {
        walk.step(start + frame / RATE / 2, motion);
        view.draw(walk.world());
      }
      view.finish();
      return (System.nanoTime() - begun) * 1e-6 / FRAMES;
    }
  }
}
