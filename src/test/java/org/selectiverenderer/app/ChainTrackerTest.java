package org.selectiverenderer.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.hmd.TrackedMotion.WhenLost;
import org.selectiverenderer.tracker.HeadTracker;
import org.selectiverenderer.tracker.PoseSample;
import org.selectiverenderer.tracker.TrackerOptions;
import org.selectiverenderer.tracker.TrackerSpec;
import org.selectiverenderer.tracker.Watching;
import org.selectiverenderer.x3d.Problem;

class ChainTrackerTest {
  private final Watching watching = new Watching();
  private final PoseSample pose = new PoseSample();

  /** A run that keeps what it hears of its tracker. */
  private static final class Hearing implements RunListener {
    final List<Problem> problems = new CopyOnWriteArrayList<>();

    @Override
    public void problem(Problem problem) {
      problems.add(problem);
    }

    @Override
    public void happened(TimelineEvent event) {
      throw new AssertionError(event);
    }

    @Override
    public void printed(String text) {
      throw new AssertionError(text);
    }
  }

  @Test
  void aHeadingResetInOneAreaHoldsInTheNext() throws IOException {
    try (ServerSocket server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
        ChainTracker chain = new ChainTracker()) {
      HeadSettings settings =
          new HeadSettings(
              TrackerSpec.parse(
                  "tcp:" + server.getInetAddress().getHostAddress() + ":" + server.getLocalPort()),
              TrackerOptions.NONE,
              WhenLost.FREEZE,
              Optional.empty(),
              HeadSettings.CONE);
      Hearing first = new Hearing();
      Hearing second = new Hearing();
      HeadTracker practice = chain.lend(settings, first);
      try (Socket device = server.accept()) {
        say(device, "30 5 0\n");
        watching.until("a pose", () -> practice.read(pose));
        practice.resetHeading();
        watching.until("straight ahead", () -> practice.read(pose) && pose.yaw() == 0);
        practice.close();

        HeadTracker kitchen = chain.lend(settings, second);
        say(device, "40 5 0\n");
        watching.until("another pose", () -> kitchen.read(pose) && pose.yaw() != 0);
        assertThat(pose.yaw()).isCloseTo(10, within(1e-9));
        assertThat(pose.pitch()).isCloseTo(5, within(1e-9));
      }
      watching.until("the loss to be heard", () -> !second.problems.isEmpty());
      assertThat(first.problems).isEmpty();
    }
  }

  private static void say(Socket device, String line) throws IOException {
    device.getOutputStream().write(line.getBytes(StandardCharsets.US_ASCII));
    device.getOutputStream().flush();
  }
}
