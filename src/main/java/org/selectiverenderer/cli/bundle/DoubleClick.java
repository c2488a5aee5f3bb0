package org.selectiverenderer.cli.bundle;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * Detects that the program was started by a double click in a file manager, which no launcher of
 * ours tells of: nobody sees a terminal then, and no other program reads what is printed.
 */
final class DoubleClick {
  private static final Path OPEN_FILES = Path.of("/proc/self/fd");

  private DoubleClick() {}

  /** Returns whether this process was started so. */
  static boolean started() {
    return started(
        System.getProperty("os.name", ""),
        ProcessHandle.current().parent().flatMap(parent -> parent.info().command()).orElse(""),
        standardStreams(),
        System.getenv());
  }

  /**
   * @param system the name of the operating system
   * @param parent the program that has started this one; empty if that is not known
   * @param streams what the three standard streams are connected to; empty where that is not known
   */
  static boolean started(
      String system, String parent, List<String> streams, Map<String, String> environment) {
    if (system.toLowerCase(Locale.ROOT).startsWith("windows")) {
      return parent.toLowerCase(Locale.ROOT).endsWith("\\explorer.exe");
    }
    return !streams.isEmpty()
        && streams.stream().noneMatch(DoubleClick::somebodyIsThere)
        && (environment.containsKey("DISPLAY") || environment.containsKey("WAYLAND_DISPLAY"));
  }

  /** Returns whether a stream is a terminal or leads to another program. */
  private static boolean somebodyIsThere(String stream) {
    return stream.startsWith("/dev/pts/")
        || stream.startsWith("/dev/tty")
        || stream.startsWith("/dev/console")
        || stream.startsWith("pipe:");
  }

  /** Returns what the standard streams are, as Linux tells it; empty on other systems. */
  private static List<String> standardStreams() {
    List<String> streams = new ArrayList<>();
    try {
      for (int i = 0; i < 3; i++) {
        streams.add(Files.readSymbolicLink(OPEN_FILES.resolve(Integer.toString(i))).toString());
      }
    } catch (IOException | UnsupportedOperationException e) {
      return List.of();
    }
    return streams;
  }
}
