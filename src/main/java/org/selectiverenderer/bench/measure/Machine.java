package org.selectiverenderer.bench.measure;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;

/** What the figures were measured on. */
final class Machine {
  private static final Path PROCESSORS = Path.of("/proc/cpuinfo");

  private Machine() {}

  static void describe(ObjectNode node) throws IOException {
    node.put("os", System.getProperty("os.name") + " " + System.getProperty("os.version"));
    node.put("arch", System.getProperty("os.arch"));
    node.put("processor", processor());
    node.put("processors", Runtime.getRuntime().availableProcessors());
    node.put(
        "java", System.getProperty("java.vm.name") + " " + System.getProperty("java.vm.version"));
    node.put("max_heap_mb", Runtime.getRuntime().maxMemory() >> 20);
  }

  private static String processor() throws IOException {
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
