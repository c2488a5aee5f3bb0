package org.selectiverenderer.app.head;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.app.settings.RunSettings;
import org.selectiverenderer.app.settings.TrackerSettings;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.hmd.HeadTrackedMotion.WhenLost;
import org.selectiverenderer.schema.Condition;
import org.selectiverenderer.tracker.PoseSample;
import org.selectiverenderer.tracker.TrackerHealth;
import org.selectiverenderer.tracker.TrackerOptions;
import org.selectiverenderer.tracker.TrackerSpec;
import org.selectiverenderer.tracker.pipeline.PublishingTracker;
import org.selectiverenderer.walkthrough.Walkthrough;

class HeadTrackingSessionTest {
  private static final TrackerSpec DEVICE = TrackerSpec.parse("tcp:127.0.0.1:5555");

  @TempDir private Path folder;

  /** A tracker whose records come when the test says so. */
  private static final class Device extends PublishingTracker {
    private final PoseSample sample = new PoseSample();
    private int sent;

    Device() {
      super(DEVICE);
    }

    void send() {
      sent++;
      sample.set(sent, 0, 0, 0, 0);
      publish(sample);
    }

    @Override
    public TrackerHealth health() {
      return new TrackerHealth(TrackerHealth.State.NONE, 0, 0, 0, 0, 0, 0, 0);
    }

    @Override
    public void close() {
      // Nothing is open.
    }
  }

  @Test
  void recordsCountAlsoWhereASimulatedParticipantTurnsTheView() throws IOException {
    Device device = new Device();
    Path scene =
        Files.writeString(
            folder.resolve("s.x3d"), "<X3D version='4.0'><Scene><Viewpoint/></Scene></X3D>");
    SelectiveController.Settings rendering = new SelectiveController.Settings(Condition.HIGH, 0);
    RunSettings settings =
        new RunSettings(scene, rendering)
            .with(
                new TrackerSettings(DEVICE, TrackerOptions.NONE, WhenLost.FREEZE),
                Optional.empty());
    List<Problem> told = new ArrayList<>();
    try (HeadTrackingSession head =
        HeadTrackingSession.with(device, new TrackerRecorder(), settings, told::add)) {
      // The motion with the tracker is not used: the guide of an unattended step replaces it.
      head.begin(
          Walkthrough.open(scene, rendering, told::add, event -> {}, text -> {}),
          (viewer, time, dt) -> {},
          null);
      for (int i = 0; i <= 8; i++) {
        device.send();
        head.stepped(frame(i));
      }
      head.stepped(new FrameTimestamp(20, 8_000_000_000L, 0, Instant.EPOCH));
      assertThat(head.longestSilence()).as("frames that are stepped at once").isZero();
      head.stepped(frame(9));
      head.stepped(frame(11));
      assertThat(head.longestSilence()).isEqualTo(3);
    }
    assertThat(told).isEmpty();
  }

  private static FrameTimestamp frame(double time) {
    return new FrameTimestamp(time, (long) (time * 1e9), 0, Instant.EPOCH);
  }
}
