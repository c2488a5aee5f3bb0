package org.selectiverenderer.tracker.net;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.BindException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.selectiverenderer.tracker.HeadTracker;
import org.selectiverenderer.tracker.Orientation;
import org.selectiverenderer.tracker.RecordingTrackerListener;
import org.selectiverenderer.tracker.TrackerException;
import org.selectiverenderer.tracker.TrackerOptions;
import org.selectiverenderer.tracker.TrackerSpec;
import org.selectiverenderer.tracker.factory.TrackerFactory;

class OpenTrackTest {
  private final RecordingTrackerListener watching = new RecordingTrackerListener();

  @Test
  void readsYawPitchAndRollBehindThePlace() throws IOException {
    int port = freePort();
    try (HeadTracker tracker = open(port);
        DatagramSocket socket = new DatagramSocket()) {
      send(socket, port, datagram(48, 10, 20, 30, 12.5, -3, 190));
      watching.until("a record", () -> watching.samples() == 1);
      assertThat(watching.orientations).containsExactly(new Orientation(12.5, -3, -170));
      assertThat(watching.places).containsExactly("0.1 0.2 0.3"); // It sends centimetres.
      assertThat(tracker.placed()).isTrue();
      assertThat(tracker.health().bad()).isZero();
    }
  }

  /** Others in a network reach it only where that is asked for. */
  @Test
  @EnabledOnOs(OS.LINUX)
  void listensOnTheLoopbackUnlessAsked() throws IOException {
    int port = freePort();
    InetAddress own = InetAddress.getByName("127.0.0.2"); // another address of Linux's loopback
    try (HeadTracker tracker = open(port)) {
      assertThatCode(() -> new DatagramSocket(port, own).close()).doesNotThrowAnyException();
      assertThat(tracker.placed()).isTrue();
    }
    try (HeadTracker tracker =
            TrackerFactory.open(
                new TrackerSpec.OpenTrack("*", port), TrackerOptions.NONE, watching);
        DatagramSocket socket = new DatagramSocket()) {
      assertThatThrownBy(() -> new DatagramSocket(port, own)).isInstanceOf(BindException.class);
      assertThat(tracker.placed()).isTrue();
      send(socket, port, datagram(48, 10, 20, 30, 1, 2, 3));
      watching.until("a record", () -> watching.samples() == 1);
    }
  }

  @Test
  void anyOtherDatagramIsBad() throws IOException {
    int port = freePort();
    try (HeadTracker tracker = open(port);
        DatagramSocket socket = new DatagramSocket()) {
      send(socket, port, new byte[0]);
      send(socket, port, new byte[47]);
      send(socket, port, new byte[49]);
      send(socket, port, new byte[1400]);
      send(socket, port, datagram(48, 0, 0, 0, Double.NaN, 0, 0));
      send(socket, port, datagram(48, 0, 0, 0, 0, Double.POSITIVE_INFINITY, 0));
      send(socket, port, datagram(48, 0, 0, 0, 0, 0, 1e9));
      watching.until("all seven", () -> tracker.health().bad() == 7);
      watching.problem("no valid records");
      send(socket, port, datagram(48, 0, 0, 0, 1, 2, 3));
      watching.problem("records arrive again");
      assertThat(watching.orientations).containsExactly(new Orientation(1, 2, 3));
    }
  }

  @Test
  void whatIsNoPlaceOfAHeadIsLeftOutAndTheAnglesAreKept() throws IOException {
    int port = freePort();
    try (HeadTracker tracker = open(port);
        DatagramSocket socket = new DatagramSocket()) {
      send(socket, port, datagram(48, 1, 2, 3, 1, 0, 0));
      send(socket, port, datagram(48, Double.NaN, 2, 3, 2, 0, 0));
      send(socket, port, datagram(48, 0, 200_000, 0, 3, 0, 0));
      watching.until("the records", () -> watching.samples() == 3);
      assertThat(tracker.health().bad()).isZero();
      assertThat(watching.places).containsExactly("0.01 0.02 0.03", "none", "none");
      assertThat(watching.orientations).extracting(Orientation::yaw).containsExactly(1.0, 2.0, 3.0);
    }
  }

  @Test
  void aFloodIsReportedOnce() throws IOException {
    int port = freePort();
    try (HeadTracker tracker = open(port);
        DatagramSocket socket = new DatagramSocket()) {
      byte[] datagram = datagram(48, 0, 0, 0, 1, 2, 3);
      watching.until(
          "the report",
          () -> {
            for (int i = 0; i < 2_000; i++) {
              send(socket, port, datagram);
            }
            return !watching.problems.isEmpty();
          });
      assertThat(watching.messages())
          .containsExactly(
              "more than 5000 records arrive per second; all are read and the latest is used");
      assertThat(tracker.health().records()).isGreaterThan(5_000);
    }
  }

  @Test
  void aPortInUseIsNamed() throws IOException {
    try (DatagramSocket other = new DatagramSocket(0)) {
      assertThatThrownBy(() -> open(other.getLocalPort()).close())
          .isInstanceOf(TrackerException.class)
          .hasMessageContaining("UDP port " + other.getLocalPort() + " is in use");
    }
  }

  private HeadTracker open(int port) throws IOException {
    return TrackerFactory.open(new TrackerSpec.OpenTrack(port), TrackerOptions.NONE, watching);
  }

  private static int freePort() throws IOException {
    try (DatagramSocket socket = new DatagramSocket(0)) {
      return socket.getLocalPort();
    }
  }

  private static byte[] datagram(int length, double... values) {
    ByteBuffer buffer = ByteBuffer.allocate(length).order(ByteOrder.LITTLE_ENDIAN);
    for (double value : values) {
      buffer.putDouble(value);
    }
    return buffer.array();
  }

  private static void send(DatagramSocket socket, int port, byte[] bytes) {
    try {
      socket.send(new DatagramPacket(bytes, bytes.length, InetAddress.getLoopbackAddress(), port));
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }
}
