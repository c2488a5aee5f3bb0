package org.selectiverenderer.tracker.serial;

import com.fazecast.jSerialComm.SerialPort;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/** The serial ports of this machine. */
public final class SerialPorts {
  /**
   * The prefix that Windows' programs put before the name of a port to open it; users leave it out.
   */
  private static final String DEVICE = "\\\\.\\";

  private SerialPorts() {}

  /**
   * Returns the names of the ports as in a tracker's SPEC: in alphabetical order, but COM2 before
   * COM10.
   *
   * @throws java.io.UncheckedIOException with one line, if the library for ports cannot be loaded
   */
  public static List<String> names() {
    SerialLibrary.load();
    return names(
        Arrays.stream(SerialPort.getCommPorts()).map(SerialPort::getSystemPortPath).toList());
  }

  /** Returns the names of ports, sorted, that are opened by some paths. */
  static List<String> names(List<String> paths) {
    return paths.stream()
        .map(path -> path.startsWith(DEVICE) ? path.substring(DEVICE.length()) : path)
        .sorted(
            Comparator.comparing((String name) -> name.replaceFirst("\\d+$", ""))
                .thenComparing(String::length)
                .thenComparing(Comparator.naturalOrder()))
        .toList();
  }

  /**
   * Returns why this user may not use a port, and which group to join. The port is not opened,
   * which would set wires that a device may act on.
   *
   * @return empty if the user may use the port, or the permissions are unknown
   */
  public static Optional<String> denied(String name) {
    return SerialPortErrors.denied(name, System.getProperty("os.name", ""));
  }
}
