package org.selectiverenderer.tracker.serial;

import com.fazecast.jSerialComm.SerialPort;
import java.util.Arrays;
import java.util.List;

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
}
