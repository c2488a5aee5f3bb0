package org.selectiverenderer.base.machine;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;

class ProgramCommandTest {
  @Test
  void theSameJavaRunsTheCommand() {
    List<String> command = ProgramCommand.of("a.Main", List.of("-Xmx1g"), List.of("run", "a.x3d"));
    assertThat(Path.of(command.get(0)).getParent())
        .isEqualTo(Path.of(System.getProperty("java.home"), "bin"));
    assertThat(command).endsWith("a.Main", "run", "a.x3d").contains("-Xmx1g", "-cp");
  }

  @Test
  void whatADesktopsLauncherOrADebuggerSaysIsNotPassedOn() {
    assertThat(
            ProgramCommand.shared(
                List.of(
                    "-Xlog:disable",
                    "-Dselective-renderer.desktop=enrich",
                    "-agentlib:jdwp=transport=dt_socket,address=8000",
                    "-Da=b")))
        .containsExactly("-Xlog:disable", "-Da=b");
  }
}
