package org.selectiverenderer.tracker.serial;

import com.fazecast.jSerialComm.SerialPort;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.base.natives.NativeLibraryFolder;
import org.selectiverenderer.base.natives.NativePlatform;
import org.selectiverenderer.tracker.TrackerException;

/**
 * Loads jSerialComm with its native library from a folder of the user's own.
 *
 * <p>jSerialComm itself takes any library that lies in {@code jSerialComm} of the folder of
 * temporary files, and before that it deletes all files there of other versions, through links too:
 * another user could have anything loaded or deleted. It does the latter even if its setting names
 * another folder. So while its class begins, the folder of temporary files is the user's own too.
 */
final class SerialLibrary {
  private static final String FOLDER = "jSerialComm.library.path";
  private static final String TEMPORARY = "java.io.tmpdir";

  private SerialLibrary() {}

  /**
   * Loads the library, unless that is done.
   *
   * @throws UncheckedIOException with one line, if there is no folder that is safe from others
   */
  static synchronized void load() {
    try {
      Optional<NativePlatform> platform = NativePlatform.current();
      if (platform.isEmpty()) {
        throw new UnsatisfiedLinkError("the program brings no library for this machine");
      }
      Path folder =
          NativeLibraryFolder.ofUser()
              .unpack(SerialPort.class, "jserialcomm", List.of(resource(platform.get())));
      if (System.getProperty(FOLDER) == null) {
        System.setProperty(FOLDER, folder.toString());
      }
      String before = System.getProperty(TEMPORARY);
      System.setProperty(TEMPORARY, folder.toString());
      try {
        Class.forName(SerialPort.class.getName()); // Begins the class.
      } finally {
        System.setProperty(TEMPORARY, before);
      }
    } catch (LinkageError | ClassNotFoundException e) {
      throw new UncheckedIOException(
          new TrackerException("serial ports cannot be used: " + e.getMessage(), e));
    }
  }

  /** Returns the resource that is jSerialComm's library for a platform. */
  static String resource(NativePlatform platform) {
    if (platform.mac()) {
      return "OSX/%s/libjSerialComm.jnilib".formatted(platform.arm() ? "aarch64" : "x86_64");
    }
    if (platform.windows()) {
      return "Windows/%s/jSerialComm.dll".formatted(platform.arm() ? "aarch64" : "x86_64");
    }
    return "Linux/%s/libjSerialComm.so".formatted(platform.arm() ? "armv8_64" : "x86_64");
  }
}
