package org.selectiverenderer.bench.measure;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.util.Optional;
import java.util.function.Consumer;
import org.selectiverenderer.base.decimal.DecimalRounding;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.bench.BenchScene;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.camera.ViewLayout;
import org.selectiverenderer.browser.viewer.CameraPath;
import org.selectiverenderer.browser.viewer.CameraPathReader;
import org.selectiverenderer.browser.viewer.PathMotion;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.render.ShadingMode;
import org.selectiverenderer.render.display.BaselineOffscreenView;
import org.selectiverenderer.render.display.OffscreenView;
import org.selectiverenderer.render.draw.BaselineRenderer;
import org.selectiverenderer.render.mesh.PackedMesh;
import org.selectiverenderer.walkthrough.Walkthrough;

/**
 * Compares our frames with the same walk drawn by a single draw call per frame: all triangles of
 * the scene, unlit, without culling. Rounds of both alternate, so that other load of the machine
 * affects both.
 *
 * <p>{@code fps_to_raw} is our frames per raw frame, the median of the rounds. It is above 1 where
 * culling saves more than lights, materials and draw calls cost.
 */
final class RawDrawMeasurement {
  private static final int WIDTH = 1024;
  private static final int HEIGHT = 768;
  private static final int ROUNDS = 5;
  private static final int FRAMES = 30;

  /** The frame rate of the walk, at which a round spans the same path as a run of a scene. */
  private static final double RATE = 6;

  private RawDrawMeasurement() {}

  /** Adds {@code raw_fps} and {@code fps_to_raw}. */
  static void measure(BenchScene scene, ObjectNode node) throws IOException {
    Optional<CameraPath> path = CameraPathReader.read(scene.path(), new ProblemCollector());
    if (path.isEmpty()) {
      throw new IOException("the benchmark's path is broken");
    }
    double[] raw = new double[ROUNDS];
    double[] ratio = new double[ROUNDS];
    try (Walkthrough walk =
        Walkthrough.open(
            scene.scene(),
            SelectiveController.Settings.SELECTIVE,
            problem -> {},
            event -> {},
            text -> {})) {
      PackedMesh triangles = BaselineRenderer.pack(walk.world().instances());
      double time = 0;
      for (int round = -1; round < ROUNDS; round++) { // The first warms up.
        double ours = ours(walk, path.get(), time);
        double yardstick = raw(walk, path.get(), triangles, time + FRAMES / RATE);
        time += 2 * FRAMES / RATE;
        if (round >= 0) {
          raw[round] = yardstick;
          ratio[round] = ours / yardstick;
        }
      }
    }
    node.put("raw_fps", DecimalRounding.to(1, Medians.median(raw)));
    node.put("fps_to_raw", DecimalRounding.to(2, Medians.median(ratio)));
  }

  private static double ours(Walkthrough walk, CameraPath path, double start) throws IOException {
    try (OffscreenView view =
        OffscreenView.open(WIDTH, HEIGHT, 0, ViewLayout.MONO, ShadingMode.AUTO)) {
      view.prepare(walk.world());
      return perSecond(walk, path, start, view::draw, view::finish);
    }
  }

  private static double raw(Walkthrough walk, CameraPath path, PackedMesh triangles, double start)
      throws IOException {
    try (BaselineOffscreenView view = new BaselineOffscreenView(triangles, WIDTH, HEIGHT)) {
      return perSecond(walk, path, start, view::draw, view::finish);
    }
  }

  private static double perSecond(
      Walkthrough walk, CameraPath path, double start, Consumer<World> draw, Runnable finish)
      throws IOException {
    // Each round walks the same way.
    PathMotion motion = new PathMotion(path, start - path.start());
    walk.step(start, motion);
    draw.accept(walk.world());
    finish.run();
    long begun = System.nanoTime();
    for (int frame = 1; frame <= FRAMES; frame++) {
      walk.step(start + frame / RATE, motion);
      draw.accept(walk.world());
    }
    finish.run();
    return FRAMES * 1e9 / (System.nanoTime() - begun);
  }
}
