package org.selectiverenderer.tracker.emulator;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.fazecast.jSerialComm.SerialPort;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.selectiverenderer.tracker.emulator.PseudoTerminal.Maker;

class PseudoTerminalTest {
  @TempDir Path folder;

  @ParameterizedTest
  @EnumSource
  void everyByteComesThroughBothWaysAndAfterOpeningAgain(Maker maker) throws IOException {
    assumeTrue(maker.installed(), maker + " is not installed");
    byte[] all = new byte[256];
    for (int i = 0; i < all.length; i++) {
      all[i] = (byte) i;
    }
    Path link = folder.resolve("port");
    try (PseudoTerminal terminal = PseudoTerminal.open(link, maker)) {
      for (int opening = 0; opening < 2; opening++) {
        SerialPort port = SerialPort.getCommPort(link.toString());
        port.setComPortTimeouts(SerialPort.TIMEOUT_READ_BLOCKING, 10_000, 0);
        assertThat(port.openPort(0)).isTrue();
        terminal.output().write(all);
        terminal.output().flush();
        byte[] read = new byte[all.length];
        assertThat(port.readBytes(read, read.length)).isEqualTo(all.length);
        assertThat(read).isEqualTo(all);
        assertThat(port.writeBytes(all, all.length)).isEqualTo(all.length);
        assertThat(terminal.input().readNBytes(all.length)).isEqualTo(all);
        assertThat(port.closePort()).isTrue();
      }
    }
    assertThat(Files.exists(link)).isFalse();
  }

  @Test
  void aFileInThePlaceOfTheLinkIsLeftAlone() throws IOException {
    Path file = Files.writeString(folder.resolve("thesis.txt"), "mine");
    assertThatThrownBy(() -> PseudoTerminal.open(file, Maker.SOCAT).close())
        .isInstanceOf(IOException.class)
        .hasMessage(file + " exists and is not a link; it is not replaced");
    assertThat(file).hasContent("mine");
  }
}
