package org.selectiverenderer.tracker.serial;

import org.selectiverenderer.tracker.TrackerException;

/**
 * A serial port by which trigger signals are sent: 8 data bits, no parity, 1 stop bit, no flow
 * control. Not thread-safe.
 */
public final class TriggerPort implements AutoCloseable {
  private final String name;
  private final SerialLine line;

  private TriggerPort(String name, SerialLine line) {
    this.name = name;
    this.line = line;
  }

  /**
   * Opens a port, with RTS and DTR off.
   *
   * @throws TrackerException if it does not exist, is in use, or is not permitted
   */
  public static TriggerPort open(String name, int speed) throws TrackerException {
    return new TriggerPort(name, SerialLine.open(name, speed));
  }

  /**
   * Sends a byte.
   *
   * @throws TrackerException if the port has disappeared
   */
  public void send(int code) throws TrackerException {
    line.write((byte) code);
  }

  /**
   * Switches the RTS wire.
   *
   * @throws TrackerException if the port has none, as a pseudo-terminal
   */
  public void requestToSend(boolean on) throws TrackerException {
    require("RTS", line.requestToSend(on));
  }

  /**
   * Switches the DTR wire.
   *
   * @throws TrackerException if the port has none, as a pseudo-terminal
   */
  public void dataTerminalReady(boolean on) throws TrackerException {
    require("DTR", line.dataTerminalReady(on));
  }

  private void require(String wire, boolean done) throws TrackerException {
    if (!done) {
      throw new TrackerException(
          "the serial port %s has no %s wire, or has disappeared".formatted(name, wire));
    }
  }

  @Override
  public void close() {
    line.close();
  }
}
