package org.selectiverenderer.base.platform;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.stream.Stream;

/** Names the computer's processor. */
public final class CpuInfo {
  private static final Path PROCESSORS = Path.of("/proc/cpuinfo");

  private CpuInfo() {}

  /** Returns the model name of the CPU as reported by the system, else {@code unknown}. */
  public static String name() throws IOException {
    return name(System.getProperty("os.name", ""), System.getenv());
  }

  /**
   * Returns the same for an operating system.
   *
   * @param system the name of the operating system, as in {@code os.name}
   * @param environment variables of the process
   */
  static String name(String system, Map<String, String> environment) throws IOException {
    // On Windows the path would be one of the current drive, where anybody's file may lie.
    if (system.equals("Linux") && Files.isReadable(PROCESSORS)) {
      try (Stream<String> lines = Files.lines(PROCESSORS)) {
        return lines
            .filter(line -> line.startsWith("model name"))
            .map(line -> line.substring(line.indexOf(':') + 1).strip())
            .findFirst()
            .orElse("unknown");
      }
    }
    return environment.getOrDefault("PROCESSOR_IDENTIFIER", "unknown");
  }
}
