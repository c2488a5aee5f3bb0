package org.selectiverenderer.hmd;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.joml.Quaterniond;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.viewer.ViewerMotion;
import org.selectiverenderer.browser.viewer.YawPitch;
import org.selectiverenderer.hmd.HeadTrackedMotion.WhenLost;
import org.selectiverenderer.tracker.HeadTracker;
import org.selectiverenderer.tracker.PoseSample;
import org.selectiverenderer.tracker.TrackerListener;
import org.selectiverenderer.tracker.TrackerOptions;
import org.selectiverenderer.tracker.TrackerSpec;
import org.selectiverenderer.tracker.emulator.EmulatedInterTrax2;
import org.selectiverenderer.tracker.emulator.InterTrax2Emulator;
import org.selectiverenderer.tracker.emulator.PseudoTerminal;
import org.selectiverenderer.tracker.factory.TrackerFactory;

/** What turns the view when an emulated tracker's cable is pulled. */
@Timeout(value = 60, unit = TimeUnit.SECONDS)
class LostTrackerTest {
  @TempDir private Path folder;

  @Test
  void theViewFreezesOrFollowsTheMouseByChoice() throws IOException, InterruptedException {
    assumeTrue(
        Arrays.stream(PseudoTerminal.Maker.values()).anyMatch(PseudoTerminal.Maker::installed));
    CountDownLatch records = new CountDownLatch(1);
    CountDownLatch lost = new CountDownLatch(1);
    TrackerListener listener =
        new TrackerListener() {
          @Override
          public void sample(PoseSample sample) {
            records.countDown();
          }

          @Override
          public void problem(Problem problem) {
            lost.countDown();
          }
        };
    Path link = folder.resolve("tracker");
    EmulatedInterTrax2 device =
        EmulatedInterTrax2.start(
            link, new InterTrax2Emulator.Settings(120, (t, into) -> into.turn(30, 0, 0)));
    try (HeadTracker tracker =
        TrackerFactory.open(
            new TrackerSpec.InterTrax2(link.toString()), TrackerOptions.NONE, listener)) {
      records.await();
      // Whoever steers turns the view by a degree in each frame.
      ViewerMotion mouse =
          (viewer, time, dt) ->
              viewer.turnTo(new Quaterniond(viewer.orientation()).rotateX(Math.toRadians(1)));
      World frozen = TestWorlds.world("<Viewpoint position='0 0 0'/>");
      World followed = TestWorlds.world("<Viewpoint position='0 0 0'/>");
      HeadTrackedMotion freeze = new HeadTrackedMotion(frozen, tracker, mouse, WhenLost.FREEZE);
      HeadTrackedMotion follow = new HeadTrackedMotion(followed, tracker, mouse, WhenLost.MOUSE);
      frozen.step(1, freeze);
      followed.step(1, follow);
      assertThat(follow.steering()).isTrue();
      assertThat(pitch(followed)).isCloseTo(0, within(0.01));
      device.unplug();
      lost.await();
      frozen.step(2, freeze);
      followed.step(2, follow);
      assertThat(freeze.steering()).isTrue();
      assertThat(pitch(frozen)).isCloseTo(0, within(0.01));
      assertThat(follow.steering()).isFalse();
      assertThat(pitch(followed)).isCloseTo(1, within(0.01));
      followed.step(3, follow);
      assertThat(pitch(followed)).isCloseTo(2, within(0.01));
    }
  }

  private static double pitch(World world) {
    return Math.toDegrees(YawPitch.of(world.viewer().orientation()).pitch());
  }
}
