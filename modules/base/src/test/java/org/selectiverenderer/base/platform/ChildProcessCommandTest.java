package org.selectiverenderer.base.platform;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ChildProcessCommandTest {
  @Test
  void theSameJavaRunsTheCommand() {
    List<String> command =
        ChildProcessCommand.of("a.Main", List.of("-Xmx1g"), List.of("run", "a.x3d"));
    assertThat(Path.of(command.get(0)).getParent())
        .isEqualTo(Path.of(System.getProperty("java.home"), "bin"));
    assertThat(command).endsWith("a.Main", "run", "a.x3d").contains("-Xmx1g", "-cp");
  }

  @Test
  void whatADesktopsLauncherADebuggerOrAParentSaysIsNotPassedOn() {
    assertThat(
            ChildProcessCommand.shared(
                List.of(
                    "-Xlog:disable",
                    "-Dselective-renderer.desktop=enrich",
                    "-agentlib:jdwp=transport=dt_socket,address=8000",
                    ParentProcessWatcher.flag(),
                    "-Da=b")))
        .containsExactly("-Xlog:disable", "-Da=b");
  }

  /** The launcher for Windows gives the JVM functions by these names, which are told as flags. */
  @Test
  void functionsOfALauncherAreNotPassedOn() {
    assertThat(ChildProcessCommand.shared(List.of("vfprintf", "exit", "abort", "-Xmx1g")))
        .containsExactly("-Xmx1g");
  }

  /** Windows opens a terminal for each java.exe that a process without one starts. */
  @Test
  void aStartFromWindowsDesktopOpensNoTerminal(@TempDir Path folder) throws IOException {
    for (String name : List.of("java.exe", "javaw.exe")) {
      assertThat(Files.createFile(folder.resolve(name)).toFile().setExecutable(true)).isTrue();
    }
    assertThat(ChildProcessCommand.java(folder, true))
        .contains(folder.resolve("javaw.exe").toString());
    assertThat(ChildProcessCommand.java(folder, false))
        .contains(folder.resolve("java.exe").toString());
    assertThat(ChildProcessCommand.java(folder.resolve("none"), true)).isEmpty();
  }
}
