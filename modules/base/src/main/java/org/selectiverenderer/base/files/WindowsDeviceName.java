package org.selectiverenderer.base.files;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.regex.Pattern;

/**
 * File names that Windows takes for a device in every folder, such as {@code NUL} and {@code
 * COM1.left.x3d} (Microsoft, "Naming Files, Paths, and Namespaces").
 */
public final class WindowsDeviceName {
  private static final Pattern DEVICE =
      Pattern.compile(
          "(?i)(con|prn|aux|nul|conin\\$|conout\\$|(com|lpt)[0-9\u00b9\u00b2\u00b3]) *(\\..*)?");

  private WindowsDeviceName() {}

  /** Returns whether a file name, without folders, is that of a device on Windows. */
  public static boolean matches(String fileName) {
    return DEVICE.matcher(fileName).matches();
  }

  /**
   * Returns whether a path leads to a device because of its name, which it does on Windows only.
   * Windows 11 has files of such names in folders.
   */
  static boolean leadsToDevice(Path file) {
    return onWindows()
        && file.getFileName() != null
        && matches(file.getFileName().toString())
        && !Files.isRegularFile(file);
  }

  /** Returns whether a path that leads to a device has an ending, so that a file was meant. */
  static boolean hasEnding(Path file) {
    return file.getFileName().toString().indexOf('.') >= 0;
  }

  private static boolean onWindows() {
    return System.getProperty("os.name", "").toLowerCase(Locale.ROOT).startsWith("windows");
  }
}
