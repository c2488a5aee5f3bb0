package org.selectiverenderer.base.platform;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.Map;
import org.junit.jupiter.api.Test;

class CpuInfoTest {
  @Test
  void onWindowsTheEnvironmentNamesTheProcessor() throws IOException {
    Map<String, String> environment =
        Map.of("PROCESSOR_IDENTIFIER", "Intel64 Family 6 Model 154 Stepping 3, GenuineIntel");
    assertThat(CpuInfo.name("Windows 11", environment))
        .isEqualTo("Intel64 Family 6 Model 154 Stepping 3, GenuineIntel");
    assertThat(CpuInfo.name("Mac OS X", Map.of())).isEqualTo("unknown");
  }
}
