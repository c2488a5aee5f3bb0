package org.selectiverenderer.app.figures;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.MemoryMXBean;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/** Reads the memory use of this process. */
final class ProcessMemory {
  private static final Path STATUS = Path.of("/proc/self/status");

  private ProcessMemory() {}

  /**
   * Returns the peak resident set size of this process in MiB. Where the operating system does not
   * report it (Linux does), returns the memory committed by the Java virtual machine.
   */
  static double peakMegabytes() {
    return linux("VmHWM:").orElseGet(ProcessMemory::committed);
  }

  private static Optional<Double> linux(String key) {
    if (!Files.isReadable(STATUS)) {
      return Optional.empty();
    }
    List<String> lines;
    try {
      lines = Files.readAllLines(STATUS);
    } catch (IOException e) {
      return Optional.empty();
    }
    return lines.stream()
        .filter(line -> line.startsWith(key))
        .findFirst()
        .map(line -> line.replaceAll("[^0-9]", ""))
        .map(kilobytes -> Long.parseLong(kilobytes) / 1024.0);
  }

  private static double committed() {
    MemoryMXBean memory = ManagementFactory.getMemoryMXBean();
    long bytes =
        memory.getHeapMemoryUsage().getCommitted() + memory.getNonHeapMemoryUsage().getCommitted();
    return bytes / 1024.0 / 1024.0;
  }
}
