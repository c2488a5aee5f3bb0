package org.selectiverenderer.tracker.serial;

import com.fazecast.jSerialComm.SerialPort;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/** The serial ports of this machine. */
public final class SerialPorts {
  private SerialPorts() {}

  /**
   * Returns the names of the ports in alphabetical order, as in a tracker's SPEC.
   *
   * @throws java.io.UncheckedIOException with one line, if the library for ports cannot be loaded
   */
  public static List<String> names() {
    SerialLibrary.load();
    return Arrays.stream(SerialPort.getCommPorts())
        .map(SerialPort::getSystemPortPath)
        .sorted()
        .toList();
  }

  /**
   * Returns why this user may not use a port, and which group to join. The port is not opened,
   * which would set wires that a device may act on.
   *
   * @return empty if the user may use the port, or the permissions are unknown
   */
  public static Optional<String> denied(String name) {
    return SerialPortErrors.denied(name);
  }
}
