package org.selectiverenderer.base.files;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class WindowsDeviceNameTest {
  @TempDir private Path folder;

  @ParameterizedTest
  @ValueSource(
      strings = {"NUL", "con", "Aux.x3d", "com1.left.x3d", "LPT9", "nul ", "com\u00b2", "CONOUT$"})
  void aDeviceHasItsNameWhateverItsCaseAndEnding(String name) {
    assertThat(WindowsDeviceName.matches(name)).isTrue();
  }

  @ParameterizedTest
  @ValueSource(strings = {"Console.x3d", "com10.x3d", "a.nul", "COM", "con_v1.x3d", ""})
  void otherNamesAreThoseOfFiles(String name) {
    assertThat(WindowsDeviceName.matches(name)).isFalse();
  }

  @Test
  @EnabledOnOs(OS.WINDOWS)
  void whatIsWrittenToTheNullDeviceIsGone() throws IOException {
    AtomicFileWriter.write(Path.of("NUL"), new byte[3]);
    AtomicFileWriter.write(folder.resolve("nul"), new byte[3]);
    assertThat(folder).isEmptyDirectory();
  }

  /** A scene that is saved to a device would be gone. */
  @Test
  @EnabledOnOs(OS.WINDOWS)
  void aSceneIsNotWrittenToADevice() {
    Path file = folder.resolve("nul.x3d");
    assertThatExceptionOfType(FileWriteException.class)
        .isThrownBy(() -> AtomicFileWriter.write(file, new byte[3]))
        .satisfies(
            failure -> assertThat(failure.reason()).contains("takes this name for a device"));
  }

  @Test
  @EnabledOnOs({OS.LINUX, OS.MAC})
  void elsewhereItIsAFileOfThatName() throws IOException {
    AtomicFileWriter.write(folder.resolve("nul"), new byte[3]);
    assertThat(folder.resolve("nul")).hasSize(3);
  }
}
