package org.selectiverenderer.tracker.net;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.tracker.HeadTracker;
import org.selectiverenderer.tracker.Orientation;
import org.selectiverenderer.tracker.RecordingTrackerListener;
import org.selectiverenderer.tracker.TrackerException;
import org.selectiverenderer.tracker.TrackerHealth.State;
import org.selectiverenderer.tracker.TrackerOptions;
import org.selectiverenderer.tracker.TrackerSpec;
import org.selectiverenderer.tracker.factory.TrackerFactory;

class TcpLinesTest {
  private final RecordingTrackerListener watching = new RecordingTrackerListener();

  @Test
  void linesOfThreeNumbersAreRead() throws IOException {
    try (ServerSocket server = server();
        HeadTracker tracker = open(server);
        Socket client = server.accept()) {
      say(client, "12.5 -3 0\n  1\t2e1 -.5 \r\n\n7 8 ");
      watching.until("two records", () -> watching.samples() == 2);
      say(client, "9\n");
      watching.until("the third", () -> watching.samples() == 3);
      assertThat(watching.orientations)
          .containsExactly(
              new Orientation(12.5, -3, 0), new Orientation(1, 20, -0.5), new Orientation(7, 8, 9));
      assertThat(tracker.health().bad()).isZero();
    }
  }

  @Test
  void commasMayStandBetweenTheNumbersButNotInThem() throws IOException {
    try (ServerSocket server = server();
        HeadTracker tracker = open(server);
        Socket client = server.accept()) {
      say(client, "1,2,3\n1.5, -2 ,\t3\n1,5 2,5 3,5\n1,5 2 3\n1,2 3\n1,2,\n,1,2\n7 8 9\n");
      watching.until("the last", () -> watching.samples() == 3);
      assertThat(watching.orientations)
          .containsExactly(
              new Orientation(1, 2, 3), new Orientation(1.5, -2, 3), new Orientation(7, 8, 9));
      assertThat(tracker.health().bad()).isEqualTo(5);
    }
  }

  @Test
  void whatIsNoLineOfNumbersIsNotPutDownToASpeed() throws IOException {
    try (ServerSocket server = server();
        HeadTracker tracker = open(server);
        Socket client = server.accept()) {
      say(client, "GET / HTTP/1.1\n");
      watching.problem("a line must be three numbers, yaw pitch roll in degrees");
      assertThat(tracker.health().bad()).isEqualTo(1);
    }
  }

  @Test
  void malformedLinesAreCounted() throws IOException {
    try (ServerSocket server = server();
        HeadTracker tracker = open(server);
        Socket client = server.accept()) {
      say(client, "1 2\n1 2 3 4\na b c\n1,5 2 3\nNaN 0 0\n0 Infinity 0\n0 0 361\n");
      say(client, "9".repeat(1000) + "\n");
      say(client, "1 2 3\n");
      watching.until("a record", () -> watching.samples() == 1);
      // Seven lines, and three times 256 bytes of one that was too long.
      assertThat(tracker.health().bad()).isEqualTo(7 + 3);
    }
  }

  @Test
  void aServerThatGoesAndComesIsFoundAgain() throws IOException {
    try (ServerSocket server = server();
        HeadTracker tracker = open(server)) {
      try (Socket client = server.accept()) {
        say(client, "1 2 3\n");
        watching.until("a record", () -> watching.samples() == 1);
      }
      watching.problem("has closed the connection on port " + server.getLocalPort());
      try (Socket client = server.accept()) {
        say(client, "4 5 6\n");
        watching.problem("records arrive again");
        watching.until("its record", () -> watching.samples() == 2);
      }
      assertThat(watching.orientations).endsWith(new Orientation(4, 5, 6));
      assertThat(tracker.health().reconnects()).isEqualTo(1);
    }
  }

  @Test
  void silenceIsReportedAfterHalfASecond() throws IOException {
    try (ServerSocket server = server();
        HeadTracker tracker = open(server);
        Socket client = server.accept()) {
      say(client, "1 2 3\n");
      watching.problem("no records for 0.5 s; the last orientation is kept");
      assertThat(tracker.health().state()).isEqualTo(State.SILENT);
      assertThat(tracker.health().silentSeconds()).isGreaterThan(0.5);
    }
  }

  @Test
  void nobodyWhoListensIsNamed() throws IOException {
    int port;
    try (ServerSocket server = server()) {
      port = server.getLocalPort();
    }
    assertThatThrownBy(() -> open("127.0.0.1", port).close())
        .isInstanceOf(TrackerException.class)
        .hasMessage("nothing listens on port " + port + " of 127.0.0.1 (is the server running?)");
  }

  @Test
  void aHostThatDoesNotExistIsNamed() {
    assertThatThrownBy(() -> open("no-such-host.invalid", 1).close())
        .isInstanceOf(TrackerException.class)
        .hasMessage("there is no host no-such-host.invalid");
  }

  private HeadTracker open(ServerSocket server) throws IOException {
    return open("127.0.0.1", server.getLocalPort());
  }

  private HeadTracker open(String host, int port) throws IOException {
    return TrackerFactory.open(new TrackerSpec.Tcp(host, port), TrackerOptions.NONE, watching);
  }

  private static ServerSocket server() throws IOException {
    return new ServerSocket(0, 5, InetAddress.getByName("127.0.0.1"));
  }

  private static void say(Socket client, String text) throws IOException {
    client.getOutputStream().write(text.getBytes(StandardCharsets.US_ASCII));
    client.getOutputStream().flush();
  }
}
