package org.selectiverenderer.browser.navigation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.joml.Vector3d;
import org.junit.jupiter.api.BeforeEach;
import org.selectiverenderer.browser.collision.TestWorld;
import org.selectiverenderer.browser.viewer.Viewer;
import org.selectiverenderer.browser.viewer.ViewpointFrame;

/** A walker 1.6 m tall, 0.25 m wide to either side, who steps over 0.3 m, at 1 m/s. */
abstract class NavigationMotionTestCase {
  static final double FRAME = 1.0 / 60;
  static final NavigationParameters SMALL_STEPS =
      new NavigationParameters(List.of(NavigationMode.WALK), 0.25, 1.6, 0.3, 1);

  final TestWorld world = new TestWorld();
  final Viewer viewer = new Viewer();
  MotionRequest motion = MotionRequest.NONE;
  double time;

  @BeforeEach
  void beginAtTheOrigin() {
    viewer.moveTo(new Vector3d(0, 1.6, 0));
  }

  NavigationMotion walker() {
    NavigationMotion walker = new NavigationMotion(world.colliders(), dt -> motion);
    walker.use(SMALL_STEPS, ViewpointFrame.WORLD);
    return walker;
  }

  void run(NavigationMotion walker, double seconds, double dt) {
    for (int i = 0; i < Math.round(seconds / dt); i++) {
      time += dt;
      walker.move(viewer, time, dt);
    }
  }

  void assertAt(double x, double y, double z, double tolerance) {
    assertThat(viewer.position().distance(x, y, z))
        .as("distance of %s from (%s, %s, %s)", viewer.position(), x, y, z)
        .isLessThan(tolerance);
  }
}
