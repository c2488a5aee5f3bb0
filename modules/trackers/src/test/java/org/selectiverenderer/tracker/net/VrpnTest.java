package org.selectiverenderer.tracker.net;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.ByteBuffer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.tracker.HeadTracker;
import org.selectiverenderer.tracker.Orientation;
import org.selectiverenderer.tracker.RecordingTrackerListener;
import org.selectiverenderer.tracker.TrackerOptions;
import org.selectiverenderer.tracker.TrackerSpec;
import org.selectiverenderer.tracker.factory.TrackerFactory;

class VrpnTest {
  private static final String COOKIE = "vrpn: ver. 07.38  0";
  private static final double HALF = Math.sqrt(0.5);

  private final RecordingTrackerListener watching = new RecordingTrackerListener();

  @Test
  void readsTheQuaternionsOfTheNamedTracker() throws IOException {
    try (FakeVrpnServer server = new FakeVrpnServer();
        HeadTracker tracker = open(server, "Tracker0")) {
      assertThat(server.welcome("vrpn: ver. 07.33  0")).isEqualTo(COOKIE);
      server.introduce();
      server.pose(FakeVrpnServer.TRACKER, 0, 0, HALF, 0, HALF); // a quarter to the left
      server.pose(1, 0, 0, 0, 0, 1); // another sender
      server.pose(FakeVrpnServer.TRACKER, 1, 0, 0, 0, 1); // another sensor
      server.message(FakeVrpnServer.TRACKER, 2, new byte[3]); // another type
      server.pose(FakeVrpnServer.TRACKER, 0, HALF, 0, 0, HALF); // straight up
      watching.until("two records", () -> watching.samples() == 2);
      assertThat(watching.orientations.get(0).yaw()).isCloseTo(90, within(1e-6));
      assertThat(watching.orientations.get(1).pitch()).isCloseTo(90, within(1e-5));
      assertThat(watching.places).containsExactly("100.0 101.0 102.0", "100.0 101.0 102.0");
      assertThat(tracker.placed()).isTrue();
      assertThat(tracker.health().bad()).isZero();
      assertThat(watching.messages()).isEmpty();
    }
  }

  @Test
  void whatIsNoUnitQuaternionIsBad() throws IOException {
    try (FakeVrpnServer server = new FakeVrpnServer();
        HeadTracker tracker = open(server, "Tracker0")) {
      server.welcome(COOKIE);
      server.introduce();
      server.pose(FakeVrpnServer.TRACKER, 0, 0, 0, 0, 0);
      server.pose(FakeVrpnServer.TRACKER, 0, Double.NaN, 0, 0, 1);
      server.pose(FakeVrpnServer.TRACKER, 0, 5, 0, 0, 1);
      server.message(FakeVrpnServer.TRACKER, FakeVrpnServer.POSE, new byte[16]);
      server.pose(FakeVrpnServer.TRACKER, 0, 0, 0, 0, 1);
      watching.until("a record", () -> watching.samples() == 1);
      assertThat(watching.orientations).containsExactly(new Orientation(0, 0, 0));
      assertThat(tracker.health().bad()).isEqualTo(4);
    }
  }

  @Test
  void aTrackerThatTheServerDoesNotHaveIsNamedWithThoseThatItHas() throws IOException {
    try (FakeVrpnServer server = new FakeVrpnServer();
        HeadTracker tracker = open(server, "Tracker9")) {
      server.welcome(COOKIE);
      server.introduce();
      watching.problem("has no tracker 'Tracker9' (it has Mouse0, Tracker0)");
      assertThat(tracker.health().records()).isZero();
    }
  }

  @Test
  void anotherVersionIsNamed() throws IOException {
    try (FakeVrpnServer server = new FakeVrpnServer();
        HeadTracker tracker = open(server, "Tracker0")) {
      server.welcome("vrpn: ver. 06.04  0");
      watching.problem("has protocol version 06.04, but this program needs 07.38");
      assertThat(tracker.health().records()).isZero();
    }
  }

  @Test
  void whatIsNotVrpnIsNamed() throws IOException {
    try (FakeVrpnServer server = new FakeVrpnServer();
        HeadTracker tracker = open(server, "Tracker0")) {
      server.welcome("HTTP/1.1 400 Bad Request");
      watching.problem("is not a VRPN server");
      assertThat(tracker.health().records()).isZero();
    }
  }

  /** The second and third are near the ends of 32 bits, where sums overflow. */
  @ParameterizedTest
  @ValueSource(ints = {0x7f000000, 0x80000014, 0x7fffffff, 0x17, -1})
  void anImpossibleLengthEndsTheConnection(int length) throws IOException {
    try (FakeVrpnServer server = new FakeVrpnServer();
        HeadTracker tracker = open(server, "Tracker0")) {
      server.welcome(COOKIE);
      server.raw(ByteBuffer.allocate(24).putInt(length).array());
      watching.problem("a message of an impossible length");
      assertThat(tracker.health().records()).isZero();
    }
  }

  @Test
  void aServerThatIsNotThereIsNamedAndALaterOneFound() throws IOException {
    try (FakeVrpnServer server = new FakeVrpnServer();
        HeadTracker tracker = open(server, "Tracker0")) {
      watching.problem("no VRPN server answers at 127.0.0.1, port " + server.port());
      // The datagrams so far ask for a connection that the client has given up.
      watching.until("a record", () -> introduced(server));
      assertThat(tracker.health().records()).isPositive();
    }
  }

  private boolean introduced(FakeVrpnServer server) {
    try {
      server.welcome(COOKIE);
      server.introduce();
      server.pose(FakeVrpnServer.TRACKER, 0, 0, 0, 0, 1);
      watching.until("it", () -> watching.samples() > 0);
      return true;
    } catch (IOException e) {
      return false; // Nobody listens at that port any more.
    }
  }

  private HeadTracker open(FakeVrpnServer server, String name) throws IOException {
    return TrackerFactory.open(
        new TrackerSpec.Vrpn(name, "127.0.0.1", server.port()), TrackerOptions.NONE, watching);
  }
}
