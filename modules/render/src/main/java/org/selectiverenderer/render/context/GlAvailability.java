package org.selectiverenderer.render.context;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Tests whether OpenGL can be used at all, without loading JOGL: without an X display JOGL's
 * classes fail to initialise, and cannot be initialised again.
 */
public final class GlAvailability {
  private static final Pattern LOCAL_DISPLAY = Pattern.compile("(?:unix)?:(\\d+)(?:\\.\\d+)?");
  private static final Duration PATIENCE = Duration.ofSeconds(5);
  private static final Path X_SOCKETS = Path.of("/tmp/.X11-unix");

  private GlAvailability() {}

  /**
   * Returns one sentence why nothing can be drawn on this machine; empty if OpenGL can be tried. An
   * X server that does not answer yet is given some seconds.
   */
  public static Optional<String> check() {
    return check(PATIENCE);
  }

  /** Checks the same without waiting. */
  static Optional<String> checkNow() {
    return check(Duration.ZERO);
  }

  private static Optional<String> check(Duration patience) {
    return check(System.getenv(), System.getProperty("os.name", ""), X_SOCKETS, patience);
  }

  static Optional<String> check(
      Map<String, String> environment, String system, Path sockets, Duration patience) {
    String name = system.toLowerCase(Locale.ROOT);
    if (name.contains("windows") || name.contains("mac")) {
      return Optional.empty();
    }
    String display = environment.getOrDefault("DISPLAY", "");
    if (display.isBlank() && !environment.getOrDefault("WAYLAND_DISPLAY", "").isBlank()) {
      return Optional.of(
          "this Wayland desktop has no X display to draw on: install XWayland (package xwayland) "
              + "and log in again");
    }
    if (display.isBlank()) {
      return Optional.of(
          "there is no display to draw on: set DISPLAY to an X server, or start one with xvfb-run");
    }
    Matcher local = LOCAL_DISPLAY.matcher(display);
    if (local.matches()
        && Files.isDirectory(sockets)
        && !there(sockets.resolve("X" + local.group(1)), patience)) {
      return Optional.of(
          "no X server answers at DISPLAY=%s; start one, or set DISPLAY to one that runs"
              .formatted(display));
    }
    return Optional.empty();
  }

  private static boolean there(Path socket, Duration patience) {
    return patience.isZero() && XServerProbe.listens(socket)
        || XServerProbe.answers(socket, patience);
  }
}
