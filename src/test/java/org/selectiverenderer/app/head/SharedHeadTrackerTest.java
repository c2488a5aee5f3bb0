package org.selectiverenderer.app.head;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.app.settings.TrackerSettings;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.hmd.HeadTrackedMotion.WhenLost;
import org.selectiverenderer.tracker.HeadTracker;
import org.selectiverenderer.tracker.PoseSample;
import org.selectiverenderer.tracker.RecordingTrackerListener;
import org.selectiverenderer.tracker.TrackerOptions;
import org.selectiverenderer.tracker.TrackerSpec;

class SharedHeadTrackerTest {
  private final RecordingTrackerListener watching = new RecordingTrackerListener();
  private final PoseSample pose = new PoseSample();

  @Test
  void aHeadingResetInOneAreaHoldsInTheNext() throws IOException {
    try (ServerSocket server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
        SharedHeadTracker chain = new SharedHeadTracker()) {
      TrackerSettings settings =
          new TrackerSettings(
              TrackerSpec.parse(
                  "tcp:" + server.getInetAddress().getHostAddress() + ":" + server.getLocalPort()),
              TrackerOptions.NONE,
              WhenLost.FREEZE);
      List<PoseSample> early = new CopyOnWriteArrayList<>();
      List<PoseSample> late = new CopyOnWriteArrayList<>();
      List<Problem> first = new CopyOnWriteArrayList<>();
      List<Problem> second = new CopyOnWriteArrayList<>();
      HeadTracker practice = chain.lend(settings, first::add, early::add);
      try (Socket device = server.accept()) {
        say(device, "30 5 0\n");
        watching.until("a pose", () -> practice.read(pose));
        practice.resetHeading();
        watching.until("straight ahead", () -> practice.read(pose) && pose.yaw() == 0);
        practice.close();

        HeadTracker kitchen = chain.lend(settings, second::add, late::add);
        say(device, "40 5 0\n");
        watching.until("another pose", () -> kitchen.read(pose) && pose.yaw() != 0);
        assertThat(pose.yaw()).isCloseTo(10, within(1e-9));
        assertThat(pose.pitch()).isCloseTo(5, within(1e-9));
        assertThat(early).hasSize(1);
        assertThat(late).isNotEmpty();
      }
      watching.until("the loss to be heard", () -> !second.isEmpty());
      assertThat(first).isEmpty();
    }
  }

  private static void say(Socket device, String line) throws IOException {
    device.getOutputStream().write(line.getBytes(StandardCharsets.US_ASCII));
    device.getOutputStream().flush();
  }
}
