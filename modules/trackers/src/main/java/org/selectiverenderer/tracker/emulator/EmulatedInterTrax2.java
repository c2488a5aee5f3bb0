package org.selectiverenderer.tracker.emulator;

import java.io.IOException;
import java.nio.file.Path;
import org.selectiverenderer.tracker.emulator.InterTrax2Emulator.Settings;

/** An emulated InterTrax2 on a pseudo-terminal, which can be unplugged and plugged in again. */
public final class EmulatedInterTrax2 implements AutoCloseable {
  private final Path link;
  private final Settings settings;
  private PseudoTerminal terminal;
  private InterTrax2Emulator device;

  private EmulatedInterTrax2(Path link, Settings settings) throws IOException {
    this.link = link;
    this.settings = settings;
    terminal = PseudoTerminal.open(link);
    device = InterTrax2Emulator.start(terminal.input(), terminal.output(), settings);
  }

  /**
   * Starts an emulated device.
   *
   * @param link path of the symbolic link to the terminal, which is created
   * @throws IOException if the terminal cannot be created
   */
  public static EmulatedInterTrax2 start(Path link, Settings settings) throws IOException {
    return new EmulatedInterTrax2(link, settings);
  }

  /** Returns the path of the emulated serial port. */
  public Path link() {
    return link;
  }

  /** Unplugs the device, which also loses its power. */
  public void unplug() throws IOException {
    device.close();
    terminal.close();
  }

  /** Plugs the device in again, after {@link #unplug}; its clock restarts. */
  public void plug() throws IOException {
    terminal = PseudoTerminal.open(link);
    device = InterTrax2Emulator.start(terminal.input(), terminal.output(), settings);
  }

  @Override
  public void close() throws IOException {
    unplug();
  }
}
