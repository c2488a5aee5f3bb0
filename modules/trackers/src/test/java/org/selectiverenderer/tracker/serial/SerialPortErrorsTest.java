package org.selectiverenderer.tracker.serial;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.tracker.RecordingTrackerListener;
import org.selectiverenderer.tracker.TrackerException;
import org.selectiverenderer.tracker.TrackerOptions;
import org.selectiverenderer.tracker.TrackerSpec;
import org.selectiverenderer.tracker.factory.TrackerFactory;

class SerialPortErrorsTest {
  @TempDir Path folder;

  @Test
  void aPortThatIsNotThereIsNamed() {
    Path none = folder.resolve("ttyUSB9");
    assertThatThrownBy(() -> open(none))
        .isInstanceOf(TrackerException.class)
        .hasMessageContaining("there is no serial port " + none);
  }

  @Test
  void aFileIsNoSerialPort() throws IOException {
    Path file = Files.writeString(folder.resolve("file"), "text");
    assertThatThrownBy(() -> open(file))
        .isInstanceOf(TrackerException.class)
        .hasMessageStartingWith(
            OS.WINDOWS.isCurrentOs()
                ? "there is no serial port " + file
                : file + " is not a serial port");
  }

  @Test
  void aPortInUseIsNamed() throws IOException {
    Path link = folder.resolve("tracker");
    try (FakeSerialDevice device = new FakeSerialDevice(link, (command, far) -> {})) {
      SerialLine line = SerialLine.open(link.toString(), 9600);
      try {
        assertThatThrownBy(() -> open(link))
            .isInstanceOf(TrackerException.class)
            .hasMessageContaining("the serial port " + link + " is in use by another program");
        assertThat(device.heard()).isEmpty();
      } finally {
        line.close();
      }
    }
  }

  @Test
  void whoMayNotIsToldWhichGroupMay() {
    assertThat(SerialPortErrors.forGroup("/dev/ttyUSB0", "uucp"))
        .isEqualTo(
            "permission denied for the serial port /dev/ttyUSB0: join the group uucp"
                + " (sudo usermod -aG uucp $USER) and log in again");
  }

  /** A device file's own permissions say who may; for the administrator there are none. */
  @Test
  @DisabledOnOs(value = OS.WINDOWS, disabledReason = "its files have no modes")
  void theGroupIsThatOfTheDevice() throws IOException {
    Path file = Files.writeString(folder.resolve("ttyS9"), "");
    Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("---rw----"));
    assumeTrue(!Files.isReadable(file), "the administrator may read everything");
    assertThat(SerialPortErrors.refused(file.toString(), 13))
        .contains("permission denied for the serial port " + file + ": join the group ");
    assertThat(SerialPorts.denied(file.toString()))
        .hasValueSatisfying(sentence -> assertThat(sentence).contains(": join the group "));
    Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("---------"));
    assertThat(SerialPortErrors.refused(file.toString(), 13)).contains(": only its owner, ");
  }

  @Test
  void whoMayIsToldNothing() throws IOException {
    Path file = Files.writeString(folder.resolve("ttyS9"), "");
    assertThat(SerialPorts.denied(file.toString())).isEmpty();
    assertThat(SerialPorts.denied("\\\\.\\COM12\0")).isEmpty();
  }

  @Test
  void portsOfWindowsAreNamedAsItsUsersKnowThem() {
    assertThat(SerialPorts.names(List.of("\\\\.\\COM10", "\\\\.\\COM1", "\\\\.\\COM2")))
        .containsExactly("COM1", "COM2", "COM10");
    assertThat(SerialPorts.names(List.of("/dev/ttyUSB0", "/dev/ttyACM1", "/dev/ttyUSB10")))
        .containsExactly("/dev/ttyACM1", "/dev/ttyUSB0", "/dev/ttyUSB10");
  }

  /** To ask whether a port may be read would open it there. */
  @Test
  @DisabledOnOs(value = OS.WINDOWS, disabledReason = "its files have no modes")
  void onWindowsEveryUserMay() throws IOException {
    Path file = Files.writeString(folder.resolve("ttyS9"), "");
    Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("---------"));
    assertThat(SerialPortErrors.denied(file.toString(), "Windows 11")).isEmpty();
  }

  @Test
  void aPortThatWindowsDoesNotHaveIsNamed() {
    assertThat(SerialPortErrors.refused("COM97", 2, "Windows 11"))
        .startsWith("there is no serial port COM97 (")
        .doesNotContain("permission");
  }

  private static void open(Path port) throws IOException {
    TrackerFactory.open(
            new TrackerSpec.InterTrax2(port.toString()),
            TrackerOptions.NONE,
            new RecordingTrackerListener())
        .close();
  }
}
