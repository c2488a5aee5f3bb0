package org.selectiverenderer.runtime.render.context;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class GlAvailabilityTest {
  @TempDir Path sockets;

  @Test
  void withoutDisplayLinuxSaysWhatToDo() {
    assertThat(GlAvailability.check(Map.of(), "Linux", sockets))
        .hasValueSatisfying(reason -> assertThat(reason).contains("DISPLAY", "xvfb-run"));
  }

  @Test
  void aLocalDisplayNeedsItsSocket() throws IOException {
    Map<String, String> environment = Map.of("DISPLAY", ":5.0");
    assertThat(GlAvailability.check(environment, "Linux", sockets))
        .hasValueSatisfying(reason -> assertThat(reason).contains(":5.0"));
    Files.createFile(sockets.resolve("X5"));
    assertThat(GlAvailability.check(environment, "Linux", sockets)).isEmpty();
  }

  @Test
  void aDisplayElsewhereIsTried() {
    assertThat(GlAvailability.check(Map.of("DISPLAY", "host:0"), "Linux", sockets)).isEmpty();
  }

  @Test
  void otherSystemsNeedNoDisplay() {
    assertThat(GlAvailability.check(Map.of(), "Windows 11", sockets)).isEmpty();
    assertThat(GlAvailability.check(Map.of(), "Mac OS X", sockets)).isEmpty();
  }
}
