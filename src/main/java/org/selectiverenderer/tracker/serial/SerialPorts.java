package org.selectiverenderer.tracker.serial;

import com.fazecast.jSerialComm.SerialPort;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/** The serial ports that a machine has. */
public final class SerialPorts {
  private SerialPorts() {}

  /** Their names, as a tracker's SPEC takes them; in their order. */
  public static List<String> names() {
    return Arrays.stream(SerialPort.getCommPorts())
        .map(SerialPort::getSystemPortPath)
        .sorted()
        .toList();
  }

  /**
   * Why this user may not use a port, and which group to join; told without opening it, which would
   * set wires that a device may act on.
   *
   * @return empty where the user may, or the system does not tell
   */
  public static Optional<String> denied(String name) {
    return SerialTrouble.denied(name);
  }
}
