package org.selectiverenderer.cli.bundle;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

class DoubleClickTest {
  private static final Map<String, String> SCREEN = Map.of("DISPLAY", ":0");

  private static boolean linux(Map<String, String> environment, String... streams) {
    return DoubleClick.started("Linux", "/usr/bin/nautilus", List.of(streams), environment);
  }

  @Test
  void aFileManagerConnectsNoTerminalAndNoOtherProgram() {
    assertThat(linux(SCREEN, "/dev/null", "socket:[12]", "socket:[12]")).isTrue();
    assertThat(linux(SCREEN, "/dev/null", "/home/me/.xsession-errors", "/dev/null")).isTrue();
  }

  @Test
  void aTerminalAScriptAndAMachineWithoutAScreenAreNoDoubleClick() {
    assertThat(linux(SCREEN, "/dev/pts/3", "/dev/pts/3", "/dev/pts/3")).isFalse();
    assertThat(linux(SCREEN, "/dev/null", "pipe:[7]", "/dev/null")).isFalse();
    assertThat(linux(Map.of(), "/dev/null", "/dev/null", "/dev/null")).isFalse();
    assertThat(linux(SCREEN)).isFalse();
  }

  @Test
  void onWindowsTheExplorerIsTheParent() {
    for (boolean clicked : new boolean[] {true, false}) {
      String parent = clicked ? "C:\\Windows\\explorer.exe" : "C:\\Windows\\System32\\cmd.exe";
      assertThat(DoubleClick.started("Windows 11", parent, List.of(), Map.of())).isEqualTo(clicked);
    }
  }
}
