package org.selectiverenderer.tracker.serial;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFileAttributes;
import java.nio.file.attribute.PosixFilePermission;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

/** Error messages for serial ports that cannot be opened. */
final class SerialPortErrors {
  /** EAGAIN on Linux and macOS, and EBUSY: another program holds the port's lock. */
  private static final Set<Integer> LOCKED = Set.of(11, 35, 16);

  private SerialPortErrors() {}

  /** Returns the message for a port that does not exist, with the names of existing ports. */
  static String absent(String port) {
    String others = SerialPorts.names().stream().limit(8).collect(Collectors.joining(", "));
    return "there is no serial port "
        + port
        + (others.isEmpty()
            ? " (this machine has none: is the adapter plugged in?)"
            : " (there is " + others + ")");
  }

  /**
   * Returns the message for an existing port that cannot be opened.
   *
   * @param code error code of the operating system
   */
  static String refused(String port, int code) {
    return refused(port, code, System.getProperty("os.name", ""));
  }

  /**
   * Returns the same for an operating system.
   *
   * @param system the name of the operating system, as in {@code os.name}
   */
  static String refused(String port, int code, String system) {
    if (windows(system)) {
      // The system's code is that of the last call, not always of the one that failed.
      String plain = port.replace("\\\\.\\", "");
      return SerialPorts.names().stream().anyMatch(plain::equalsIgnoreCase)
          ? "the serial port "
              + port
              + " cannot be opened: another program uses it, or its device does not answer; close"
              + " that program, or pull the cable and plug it in again"
          : absent(port);
    }
    try {
      Path device = Path.of(port);
      if (Files.exists(device)) {
        return refused(port, device, code);
      }
    } catch (InvalidPathException e) {
      // A name such as \\.\COM12, which is not a path.
    }
    return "the serial port "
        + port
        + " cannot be opened: another program uses it, or you have no permission (error "
        + code
        + ")";
  }

  /**
   * Returns the message for a port whose file this user may not read and write; empty for other
   * ports.
   *
   * @param system the name of the operating system, as in {@code os.name}
   */
  static Optional<String> denied(String port, String system) {
    if (windows(system)) {
      return Optional.empty(); // Every user may use a port, and asking would open it.
    }
    try {
      Path device = Path.of(port);
      return Files.exists(device) && !(Files.isReadable(device) && Files.isWritable(device))
          ? Optional.of(denied(port, device))
          : Optional.empty();
    } catch (InvalidPathException e) {
      return Optional.empty(); // A name such as \\.\COM12, which has no permissions.
    }
  }

  private static String refused(String port, Path device, int code) {
    if (!Files.isReadable(device) || !Files.isWritable(device)) {
      return denied(port, device);
    }
    if (Files.isRegularFile(device) || Files.isDirectory(device)) {
      return port + " is not a serial port";
    }
    return "the serial port "
        + port
        + " is in use by another program"
        + (LOCKED.contains(code) ? "" : ", or is not a serial port (error " + code + ")");
  }

  private static String denied(String port, Path device) {
    try {
      PosixFileAttributes attributes =
          Files.readAttributes(device.toRealPath(), PosixFileAttributes.class);
      Set<PosixFilePermission> may = attributes.permissions();
      return may.contains(PosixFilePermission.GROUP_READ)
              && may.contains(PosixFilePermission.GROUP_WRITE)
          ? forGroup(port, attributes.group().getName())
          : unusable(port)
              + ": only its owner, "
              + attributes.owner().getName()
              + ", has permission to use it";
    } catch (IOException | UnsupportedOperationException e) {
      return unusable(port); // Not a POSIX system, or the device has just disappeared.
    }
  }

  private static boolean windows(String system) {
    return system.toLowerCase(Locale.ROOT).startsWith("windows");
  }

  private static String unusable(String port) {
    return "permission denied for the serial port " + port;
  }

  /**
   * Returns the message for a port without permission.
   *
   * @param group group with permission
   */
  static String forGroup(String port, String group) {
    return unusable(port)
        + ": join the group "
        + group
        + " (sudo usermod -aG "
        + group
        + " $USER) and log in again";
  }
}
