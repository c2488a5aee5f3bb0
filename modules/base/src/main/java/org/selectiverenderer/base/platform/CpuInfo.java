package org.selectiverenderer.base.platform;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;

/** Names the computer's processor. */
public final class CpuInfo {
  private static final Path PROCESSORS = Path.of("/proc/cpuinfo");

  private CpuInfo() {}

  /** Returns the model name of the CPU as reported by the system, else {@code unknown}. */
  public static String name() throws IOException {
    if (Files.isReadable(PROCESSORS)) {
      try (Stream<String> lines = Files.lines(PROCESSORS)) {
        return lines
            .filter(line -> line.startsWith("model name"))
            .map(line -> line.substring(line.indexOf(':') + 1).strip())
            .findFirst()
            .orElse("unknown");
      }
    }
    String named = System.getenv("PROCESSOR_IDENTIFIER");
    return named == null ? "unknown" : named;
  }
}
