package org.selectiverenderer.bench.measure;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.app.Walkthrough;
import org.selectiverenderer.bench.BenchScene;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.hmd.DisplayProfile;
import org.selectiverenderer.hmd.EyeGeometry;
import org.selectiverenderer.hmd.StereoLayout;
import org.selectiverenderer.runtime.navigation.CameraPath;
import org.selectiverenderer.runtime.navigation.CameraPathReader;
import org.selectiverenderer.runtime.navigation.PathMotion;
import org.selectiverenderer.runtime.render.OffscreenView;
import org.selectiverenderer.runtime.render.ViewLayout;
import org.selectiverenderer.x3d.Problems;

/**
 * Times frames of one eye and of both, of the same walk through the same scene: the whole update
 * and drawing, each eye's picture as large as the display's. Rounds alternate, so that whatever
 * else the machine does falls on both.
 */
final class StereoCost {
  private static final int ROUNDS = 6;
  private static final int FRAMES = 60;
  private static final double RATE = 30;

  private StereoCost() {}

  static void measure(BenchScene scene, DisplayProfile profile, ObjectNode node)
      throws IOException {
    StereoLayout both =
        new StereoLayout(
            new EyeGeometry(profile, EyeGeometry.MEAN_IPD / 1000),
            StereoLayout.Arrangement.SIDE_BY_SIDE);
    ViewLayout one =
        (world, width, height, range) ->
            List.of(both.views(world, 2 * width, height, range).get(0));
    Optional<CameraPath> path = CameraPathReader.read(scene.path(), new Problems());
    if (path.isEmpty()) {
      throw new IOException("the benchmark's path is broken");
    }
    double[] single = new double[ROUNDS];
    double[] twice = new double[ROUNDS];
    try (Walkthrough walk =
        Walkthrough.open(
            scene.scene(),
            SelectiveController.Settings.SELECTIVE,
            problem -> {},
            event -> {},
            text -> {})) {
      double time = 0;
      for (int round = -1; round < ROUNDS; round++) { // The first warms up.
        double singleMs = frames(walk, path.get(), profile, 1, one, time);
        double twiceMs = frames(walk, path.get(), profile, 2, both, time + FRAMES / RATE);
        time += 2 * FRAMES / RATE;
        if (round >= 0) {
          single[round] = singleMs;
          twice[round] = twiceMs;
        }
      }
    }
    double oneEye = Figures.median(single);
    double twoEyes = Figures.median(twice);
    node.put("eye_width", profile.width());
    node.put("eye_height", profile.height());
    node.put("one_eye_ms", Figures.tenth(oneEye));
    node.put("both_eyes_ms", Figures.tenth(twoEyes));
    node.put("second_eye_to_first", Math.round(100 * (twoEyes - oneEye) / oneEye) / 100.0);
  }

  /** Milliseconds per frame. */
  private static double frames(
      Walkthrough walk,
      CameraPath path,
      DisplayProfile profile,
      int eyes,
      ViewLayout layout,
      double start)
      throws IOException {
    try (OffscreenView view =
        OffscreenView.open(eyes * profile.width(), profile.height(), 0, layout)) {
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
