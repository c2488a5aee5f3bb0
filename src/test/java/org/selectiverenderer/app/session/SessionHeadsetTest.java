package org.selectiverenderer.app.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.app.headset.HeadsetConnection;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.hmd.HeadsetViewSettings;
import org.selectiverenderer.openxr.FakeHeadset;
import org.selectiverenderer.openxr.HeadsetUnavailableException;
import org.selectiverenderer.render.headset.GlContextHandles;
import org.selectiverenderer.tracker.HeadTracker;
import org.selectiverenderer.tracker.PoseSample;
import org.selectiverenderer.tracker.TrackerListener;

/** One headset for all scenes of a session, and one tracker. */
class SessionHeadsetTest {
  private static final GlContextHandles HANDLES = new GlContextHandles.Wgl(1, 2);

  private final FakeHeadset device = new FakeHeadset();
  private final SessionHeadset headset =
      new SessionHeadset(
          HeadsetViewSettings.standing(), shown -> HeadsetConnection.with(device.search(), shown));
  private final List<Double> yaws = new ArrayList<>();
  private final TrackerListener hears =
      new TrackerListener() {
        @Override
        public void sample(PoseSample sample) {
          yaws.add(sample.yaw());
        }

        @Override
        public void problem(Problem problem) {
          throw new AssertionError(problem);
        }
      };

  private void look(HeadsetConnection link, double yaw) {
    device.head(new Vector3d(0, 1.7, 0), new Quaterniond().rotationY(Math.toRadians(yaw)));
    assertThat(link.next()).isPresent();
    link.begin();
    link.end(false);
  }

  @Test
  void aSessionBeginsOnlyWithAHeadsetAndLeavesItFreeUntilItShowsSomething() throws IOException {
    assertThat(headset.require())
        .isEqualTo("headset Test headset by Fake 1.2.3, pictures of 400x300 for each eye");
    assertThat(device.connections()).isZero();
    device.plugged(false);
    assertThatThrownBy(headset::require)
        .isInstanceOf(HeadsetUnavailableException.class)
        .hasMessageContaining("Fake 1.2.3");
    assertThat(device.connections()).isZero();
  }

  @Test
  void aHeadsetWithAnEyeTrackerSaysSo() throws IOException {
    device.withEyes();
    assertThat(headset.require()).endsWith("for each eye, tracks the eyes");
  }

  @Test
  void oneTrackerHasThePosesOfAllScenes() throws IOException {
    try (HeadTracker tracker = headset.tracker(hears)) {
      assertThat(tracker.described()).contains("headset: not in use");
      for (double yaw : new double[] {30, -45}) {
        try (HeadsetConnection link = headset.connect()) {
          link.open(HANDLES);
          device.wear();
          look(link, yaw);
          assertThat(tracker.described().orElseThrow()).contains("Fake 1.2.3");
        }
        assertThat(device.connections()).isZero();
      }
    }
    assertThat(yaws).hasSize(2);
    assertThat(yaws.get(0)).isCloseTo(30, within(1e-6));
    assertThat(yaws.get(1)).isCloseTo(-45, within(1e-6));
  }

  @Test
  void aHeadsetThatIsGoneBetweenTwoScenesIsSaidToBe() throws IOException {
    headset.connect().close();
    device.plugged(false);
    assertThatThrownBy(headset::connect).isInstanceOf(IOException.class);
    assertThat(device.connections()).isZero();
  }

  @Test
  void whereTheEyesLookComesWithTheFrame() throws IOException {
    device.withEyes();
    headset.tracker(hears).close();
    try (HeadsetConnection link = headset.connect()) {
      assertThat(link.tracksEyes()).isTrue();
      link.open(HANDLES);
      device.wear();
      device.look(Optional.of(new Quaterniond().rotationY(Math.PI / 2)));
      look(link, 0);
      assertThat(link.gaze().orElseThrow().x).isCloseTo(-1, within(1e-9));
      device.look(Optional.empty());
      look(link, 0);
      assertThat(link.gaze()).isEmpty();
    }
  }
}
