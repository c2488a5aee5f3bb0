package org.selectiverenderer.app.trigger;

import java.io.IOException;
import org.selectiverenderer.study.definition.TriggerSettings.Wire;
import org.selectiverenderer.tracker.serial.TriggerPort;

/** Where trigger signals go. Used by one thread at a time. */
interface TriggerOutput extends AutoCloseable {
  /**
   * Sends a byte.
   *
   * @throws IOException with one line, if it cannot be sent
   */
  void send(int code) throws IOException;

  /**
   * Switches a wire.
   *
   * @throws IOException with one line, if there is none
   */
  void line(Wire wire, boolean on) throws IOException;

  @Override
  void close();

  /** Opens an output. */
  @FunctionalInterface
  interface Opener {
    /**
     * Opens the output, again after a failure.
     *
     * @throws IOException with one line, if that is not possible
     */
    TriggerOutput open() throws IOException;
  }

  /** Opens a serial port. */
  static TriggerOutput serial(String name, int speed) throws IOException {
    TriggerPort port = TriggerPort.open(name, speed);
    return new TriggerOutput() {
      @Override
      public void send(int code) throws IOException {
        port.send(code);
      }

      @Override
      public void line(Wire wire, boolean on) throws IOException {
        switch (wire) {
          case RTS -> port.requestToSend(on);
          case DTR -> port.dataTerminalReady(on);
        }
      }

      @Override
      public void close() {
        port.close();
      }
    };
  }
}
