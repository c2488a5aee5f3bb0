package org.selectiverenderer.bench.measure;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import org.joml.Vector3dc;
import org.selectiverenderer.base.decimal.DecimalRounding;
import org.selectiverenderer.bench.BenchScene;
import org.selectiverenderer.browser.viewer.ViewerMotion;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.walkthrough.Walkthrough;

/**
 * Measures the time of an activation: enters and leaves an area whose schemas affect a few of very
 * many Switches, and times the whole frame: sensor, event cascade, controller, instance tree.
 */
final class ActivationMeasurement {
  /**
   * The number of measured rounds. Java's just-in-time compilers are done after about 4,000
   * changes: in the first 400 a change takes two to four times as long as later.
   */
  private static final int ROUNDS = 4000;

  private ActivationMeasurement() {}

  static void measure(BenchScene scene, int affected, ObjectNode node) throws IOException {
    long begun = System.nanoTime();
    try (Walkthrough walk =
        Walkthrough.open(
            scene.scene(),
            SelectiveController.Settings.SELECTIVE,
            problem -> {},
            event -> {},
            text -> {})) {
      double loadMs = (System.nanoTime() - begun) * 1e-6;
      node.put("switches", scene.switches());
      node.put("affected", affected);
      frames(walk, scene, 0, ROUNDS, node);
      if (walk.enteredAreas().size() > 1) {
        throw new IOException("the benchmark's scene does not behave");
      }
      node.put("load_ms", DecimalRounding.to(1, loadMs));
    }
  }

  /**
   * Steps in and out of the area.
   *
   * @param time present time of the walkthrough
   * @param rounds measured, after as many to warm up
   */
  static void frames(Walkthrough walk, BenchScene scene, double time, int rounds, ObjectNode node) {
    double[] changing = new double[rounds];
    double[] resting = new double[rounds];
    double now = time;
    for (int round = 0; round < 2 * rounds; round++) {
      // The first half warms up.
      int at = round % rounds;
      Vector3dc eye = round % 2 == 0 ? scene.inside() : scene.outside();
      changing[at] = step(walk, now += 0.01, eye);
      resting[at] = step(walk, now += 0.01, eye);
    }
    node.put("us", DecimalRounding.to(1, Medians.median(changing)));
    node.put("idle_frame_us", DecimalRounding.to(1, Medians.median(resting)));
  }

  private static double step(Walkthrough walk, double time, Vector3dc eye) {
    ViewerMotion motion = (viewer, now, dt) -> viewer.moveTo(eye);
    long begun = System.nanoTime();
    walk.step(time, motion);
    return (System.nanoTime() - begun) * 1e-3;
  }
}
