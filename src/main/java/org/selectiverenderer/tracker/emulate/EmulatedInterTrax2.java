package org.selectiverenderer.tracker.emulate;

import java.io.IOException;
import java.nio.file.Path;
import org.selectiverenderer.tracker.emulate.InterTrax2Emulator.Settings;

/** An emulated InterTrax2 with its cable: opened by a link, pulled and plugged in again. */
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
   * Plugs one in.
   *
   * @param link becomes a link to its terminal
   * @throws IOException if the terminal cannot be made
   */
  public static EmulatedInterTrax2 start(Path link, Settings settings) throws IOException {
    return new EmulatedInterTrax2(link, settings);
  }

  /** Where its serial port is. */
  public Path link() {
    return link;
  }

  /** Pulls the cable, which also takes the device's power. */
  public void unplug() throws IOException {
    device.close();
    terminal.close();
  }

  /** Plugs it in again, after {@link #unplug}; its clock begins anew. */
  public void plug() throws IOException {
    terminal = PseudoTerminal.open(link);
    device = InterTrax2Emulator.start(terminal.input(), terminal.output(), settings);
  }

  @Override
  public void close() throws IOException {
    unplug();
  }
}
