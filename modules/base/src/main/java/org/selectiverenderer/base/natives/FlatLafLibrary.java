package org.selectiverenderer.base.natives;

import java.io.UncheckedIOException;
import java.util.List;
import java.util.Optional;

/**
 * Makes FlatLaf, the look of our Swing windows, load its native part from a folder of the user's
 * own.
 */
public final class FlatLafLibrary {
  private static final String FOLDER = "flatlaf.nativeLibraryPath";

  private FlatLafLibrary() {}

  /**
   * Unpacks the library. To be called before FlatLaf is set up; a second call does nothing. Where
   * there is no safe folder FlatLaf does without: the system then frames its windows.
   *
   * @param owner a class whose loader finds FlatLaf
   */
  public static synchronized void use(Class<?> owner) {
    Optional<NativePlatform> platform = NativePlatform.current();
    if (platform.isEmpty() || System.getProperty(FOLDER) != null) {
      return;
    }
    try {
      System.setProperty(
          FOLDER,
          NativeLibraryFolder.ofUser()
              .unpack(owner, "flatlaf", List.of(resource(platform.get())))
              .toString());
    } catch (UncheckedIOException e) {
      System.setProperty("flatlaf.useNativeLibrary", "false");
    }
  }

  /** Returns the resource that is FlatLaf's library for a platform. */
  static String resource(NativePlatform platform) {
    String system = platform.windows() ? "windows" : platform.mac() ? "macos" : "linux";
    String processor = platform.arm() ? "arm64" : "x86_64";
    return "com/formdev/flatlaf/natives/"
        + platform.file("flatlaf-%s-%s".formatted(system, processor));
  }
}
