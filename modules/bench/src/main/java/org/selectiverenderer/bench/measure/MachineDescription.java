package org.selectiverenderer.bench.measure;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import org.selectiverenderer.base.platform.CpuInfo;

/** Describes the machine of the measurements. */
final class MachineDescription {
  private MachineDescription() {}

  static void describe(ObjectNode node) throws IOException {
    node.put("os", System.getProperty("os.name") + " " + System.getProperty("os.version"));
    node.put("arch", System.getProperty("os.arch"));
    node.put("processor", CpuInfo.name());
    node.put("processors", Runtime.getRuntime().availableProcessors());
    node.put(
        "java", System.getProperty("java.vm.name") + " " + System.getProperty("java.vm.version"));
    node.put("max_heap_mb", Runtime.getRuntime().maxMemory() >> 20);
  }
}
