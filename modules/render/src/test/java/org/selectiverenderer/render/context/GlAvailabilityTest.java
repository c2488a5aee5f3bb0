package org.selectiverenderer.render.context;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.StandardProtocolFamily;
import java.net.UnixDomainSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

class GlAvailabilityTest {
  private static final Duration ONCE = Duration.ZERO;
  @TempDir Path sockets;

  @Test
  void withoutDisplayLinuxSaysWhatToDo() {
    assertThat(GlAvailability.check(Map.of(), "Linux", sockets, ONCE))
        .hasValueSatisfying(reason -> assertThat(reason).contains("DISPLAY", "xvfb-run"));
  }

  @Test
  void aWaylandDesktopWithoutXWaylandIsToldWhatItLacks() {
    Map<String, String> environment = Map.of("WAYLAND_DISPLAY", "wayland-0");
    assertThat(GlAvailability.check(environment, "Linux", sockets, ONCE))
        .hasValueSatisfying(
            reason -> assertThat(reason).contains("XWayland").doesNotContain("xvfb"));
  }

  @Test
  @DisabledOnOs(value = OS.WINDOWS, disabledReason = "no X server draws there")
  void aServerThatNobodyRunsIsNamed() throws IOException {
    Map<String, String> environment = Map.of("DISPLAY", ":5.0");
    assertThat(GlAvailability.check(environment, "Linux", sockets, ONCE))
        .hasValueSatisfying(reason -> assertThat(reason).contains(":5.0", "start one"));
    Files.createFile(sockets.resolve("X5")); // What a server that was killed may leave behind.
    assertThat(GlAvailability.check(environment, "Linux", sockets, ONCE)).isPresent();
  }

  @Test
  void whoListensIsSeenInLinuxsListOfSockets() {
    List<String> list =
        List.of(
            "Num       RefCount Protocol Flags    Type St Inode Path",
            "000000003fd7b082: 00000003 00000000 00000000 0001 03   494",
            "0000000004802468: 00000002 00000000 00010000 0001 01 10200 /tmp/.X11-unix/X7",
            "00000000eaacc513: 00000002 00000000 00010000 0001 01 1020030 @/tmp/.X11-unix/X8",
            "00000000eaacc514: 00000003 00000000 00000000 0001 03 1020031 /tmp/.X11-unix/X9");
    assertThat(XServerProbe.listens(list, "/tmp/.X11-unix/X7")).isTrue();
    assertThat(XServerProbe.listens(list, "/tmp/.X11-unix/X8")).isTrue();
    assertThat(XServerProbe.listens(list, "/tmp/.X11-unix/X9")).as("a connection").isFalse();
    assertThat(XServerProbe.listens(list, "/tmp/.X11-unix/X")).isFalse();
  }

  @Test
  @DisabledOnOs(value = OS.WINDOWS, disabledReason = "no X server draws there")
  void aServerThatDoesNotAnswerYetIsWaitedFor() throws Exception {
    Map<String, String> environment = Map.of("DISPLAY", ":5.0");
    try (ServerSocketChannel server = ServerSocketChannel.open(StandardProtocolFamily.UNIX)) {
      server.bind(UnixDomainSocketAddress.of(sockets.resolve("X5")));
      AtomicInteger greetings = new AtomicInteger();
      Thread late = new Thread(() -> answerTheSecond(server, greetings), "late-server");
      late.start();
      assertThat(GlAvailability.check(environment, "Linux", sockets, Duration.ofSeconds(30)))
          .isEmpty();
      late.join();
      assertThat(greetings).hasValue(2);
    }
  }

  private static void answerTheSecond(ServerSocketChannel server, AtomicInteger greetings) {
    try {
      server.accept().close();
      greetings.incrementAndGet();
      try (SocketChannel client = server.accept()) {
        client.read(ByteBuffer.allocate(12));
        greetings.incrementAndGet();
        client.write(ByteBuffer.wrap(new byte[] {1}));
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Test
  void aDisplayElsewhereIsTried() {
    assertThat(GlAvailability.check(Map.of("DISPLAY", "host:0"), "Linux", sockets, ONCE)).isEmpty();
  }

  @Test
  void otherSystemsNeedNoDisplay() {
    assertThat(GlAvailability.check(Map.of(), "Windows 11", sockets, ONCE)).isEmpty();
    assertThat(GlAvailability.check(Map.of(), "Mac OS X", sockets, ONCE)).isEmpty();
  }
}
