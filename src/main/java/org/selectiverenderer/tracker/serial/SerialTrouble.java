package org.selectiverenderer.tracker.serial;

import com.fazecast.jSerialComm.SerialPort;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Sentences about serial ports that cannot be opened. */
final class SerialTrouble {
  private SerialTrouble() {}

  /** For a port that is not there; names those that are. */
  static String absent(String port) {
    String others =
        Stream.of(SerialPort.getCommPorts())
            .map(SerialPort::getSystemPortPath)
            .sorted()
            .limit(8)
            .collect(Collectors.joining(", "));
    return "there is no serial port "
        + port
        + (others.isEmpty()
            ? " (this machine has none: is the adapter plugged in?)"
            : " (there is " + others + ")");
  }

  /**
   * For a port that is there but does not open.
   *
   * @param code of the system's error, as the library tells it
   */
  static String refused(String port, int code) {
    try {
      Path device = Path.of(port);
      if (Files.exists(device)) {
        return refused(port, device, code);
      }
    } catch (InvalidPathException e) {
      // A name such as \\.\COM12: what follows does not need a file.
    }
    return "the serial port "
        + port
        + " cannot be opened: another program uses it, or this user may not (error "
        + code
        + ")";
  }

  private static String refused(String port, Path device, int code) {
    if (!Files.isReadable(device) || !Files.isWritable(device)) {
      return denied(port, group(device));
    }
    if (Files.isRegularFile(device) || Files.isDirectory(device)) {
      return port + " is no serial port";
    }
    return "the serial port "
        + port
        + " is in use by another program, or is no serial port (error "
        + code
        + ")";
  }

  /**
   * For a port that this user may not use.
   *
   * @param group that may; empty when unknown
   */
  static String denied(String port, String group) {
    String known = group.isEmpty() ? "dialout" : group;
    return "permission denied for the serial port "
        + port
        + ": join the group "
        + known
        + " (sudo usermod -aG "
        + known
        + " $USER) and log in again";
  }

  private static String group(Path device) {
    try {
      return Files.getAttribute(device.toRealPath(), "posix:group", LinkOption.NOFOLLOW_LINKS)
          .toString();
    } catch (IOException | UnsupportedOperationException e) {
      return ""; // Not a POSIX system; the sentence does without.
    }
  }
}
