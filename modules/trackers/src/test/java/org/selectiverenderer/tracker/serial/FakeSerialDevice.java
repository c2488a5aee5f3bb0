package org.selectiverenderer.tracker.serial;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.selectiverenderer.tracker.emulator.PseudoTerminal;
import org.selectiverenderer.tracker.emulator.PseudoTerminal.Maker;

/** The far end of a serial cable: a device that a test plays itself. */
final class FakeSerialDevice implements AutoCloseable {
  /** What the device does with a byte from the host. */
  interface Reaction {
    void hears(int command, FakeSerialDevice device) throws IOException;
  }

  private final PseudoTerminal terminal;
  private final Thread thread;
  private final StringBuffer heard = new StringBuffer();

  FakeSerialDevice(Path link, Reaction reaction) throws IOException {
    assumeTrue(Stream.of(Maker.values()).anyMatch(Maker::installed), "no socat, no script");
    terminal = PseudoTerminal.open(link);
    thread = new Thread(() -> listen(reaction), "far-end");
    thread.start();
  }

  private void listen(Reaction reaction) {
    try {
      int command = terminal.input().read();
      while (command >= 0) {
        heard.append((char) command);
        reaction.hears(command, this);
        command = terminal.input().read();
      }
    } catch (IOException e) {
      heard.append("<pulled>");
    }
  }

  /** All that the host has sent, a character per byte. */
  String heard() {
    return heard.toString();
  }

  void says(int... bytes) throws IOException {
    for (int b : bytes) {
      terminal.output().write(b);
    }
    terminal.output().flush();
  }

  void says(byte[] bytes) throws IOException {
    terminal.output().write(bytes);
    terminal.output().flush();
  }

  @Override
  public void close() throws IOException {
    terminal.close();
    try {
      thread.join();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
