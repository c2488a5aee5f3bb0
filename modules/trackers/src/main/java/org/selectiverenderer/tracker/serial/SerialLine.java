package org.selectiverenderer.tracker.serial;

import com.fazecast.jSerialComm.SerialPort;
import com.fazecast.jSerialComm.SerialPortInvalidPortException;
import java.io.UncheckedIOException;
import java.util.concurrent.locks.LockSupport;
import org.selectiverenderer.tracker.TrackerException;

/**
 * An open serial port: 8 data bits, no parity, 1 stop bit, no flow control, DTR and RTS off. It
 * wraps jSerialComm.
 */
final class SerialLine {
  /**
   * Timeout in milliseconds for the first byte of a read; the system's timers count tenths of a
   * second.
   */
  static final int READ_MS = 100;

  /** The error as which Wine reports a timeout, where Windows reports no bytes. */
  private static final int TIMED_OUT = 1460;

  /** Maximum time to discard old bytes, as a streaming device is never quiet. */
  private static final long STALE_NANOS = 100_000_000;

  private static final int QUIET_LOOKS = 4;
  private static final long LOOK_NANOS = 500_000;

  private final String name;
  private final SerialPort port;

  private SerialLine(String name, SerialPort port) {
    this.name = name;
    this.port = port;
  }

  /**
   * Opens a port.
   *
   * @throws TrackerException if the port does not exist, is in use, or is not permitted
   */
  static SerialLine open(String name, int baud) throws TrackerException {
    SerialPort port;
    try {
      SerialLibrary.load();
      port = SerialPort.getCommPort(name);
    } catch (UncheckedIOException e) {
      throw new TrackerException(e.getCause().getMessage(), e);
    } catch (SerialPortInvalidPortException e) {
      throw new TrackerException(SerialPortErrors.absent(name), e);
    }
    port.setComPortParameters(baud, 8, SerialPort.ONE_STOP_BIT, SerialPort.NO_PARITY);
    port.setFlowControl(SerialPort.FLOW_CONTROL_DISABLED);
    // Semi-blocking would do the same in one call, but never times out under Wine.
    port.setComPortTimeouts(SerialPort.TIMEOUT_READ_BLOCKING, READ_MS, 0);
    if (!port.openPort(0)) {
      throw new TrackerException(SerialPortErrors.refused(name, port.getLastErrorCode()));
    }
    // Failures are ignored, as a pseudo-terminal has no such wires.
    port.clearDTR();
    port.clearRTS();
    SerialLine line = new SerialLine(name, port);
    line.discardStale();
    return line;
  }

  /**
   * Discards bytes that arrived before the port was opened, which are old poses. A pseudo-terminal
   * or an adapter may buffer more than the system shows, which follows at once.
   */
  private void discardStale() {
    port.flushIOBuffers();
    byte[] bytes = new byte[4096];
    long end = System.nanoTime() + STALE_NANOS;
    int quiet = 0;
    while (quiet < QUIET_LOOKS && System.nanoTime() < end) {
      int waiting = port.bytesAvailable();
      if (waiting > 0) {
        port.readBytes(bytes, Math.min(waiting, bytes.length));
        quiet = 0;
      } else {
        quiet++;
        LockSupport.parkNanos(LOOK_NANOS);
      }
    }
  }

  /**
   * Reads available bytes, or waits for one up to {@link #READ_MS}.
   *
   * @return the number of bytes read, 0 after a timeout
   * @throws TrackerException if the port has disappeared
   */
  int read(byte[] bytes) throws TrackerException {
    int waiting = Math.max(1, port.bytesAvailable());
    int count = port.readBytes(bytes, Math.min(waiting, bytes.length));
    if (count < 0 && port.getLastErrorCode() != TIMED_OUT) {
      throw gone();
    }
    return Math.max(0, count);
  }

  /**
   * Writes bytes.
   *
   * @throws TrackerException if the port has disappeared
   */
  void write(byte... bytes) throws TrackerException {
    if (port.writeBytes(bytes, bytes.length) != bytes.length) {
      throw gone();
    }
  }

  /** Changes the speed and discards bytes received at the old one. */
  void speed(int baud) {
    port.setBaudRate(baud);
    port.flushIOBuffers();
  }

  /**
   * Sets the RTS wire.
   *
   * @return whether this port has an RTS wire
   */
  boolean requestToSend(boolean on) {
    return on ? port.setRTS() : port.clearRTS();
  }

  /**
   * Sets the DTR wire.
   *
   * @return whether this port has a DTR wire
   */
  boolean dataTerminalReady(boolean on) {
    return on ? port.setDTR() : port.clearDTR();
  }

  void close() {
    port.closePort();
  }

  private TrackerException gone() {
    return new TrackerException(
        "the serial port " + name + " has disappeared (was the cable pulled?)");
  }
}
