package org.selectiverenderer.base.files;

import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;

/** Finds the user's configuration folder by the convention of each operating system. */
public final class SettingsFolder {
  private static final String NAME = "selective-renderer";

  private SettingsFolder() {}

  /** Returns the configuration folder of the user who runs this process. */
  public static Path ofUser() {
    return of(
        System.getProperty("os.name", ""),
        Path.of(System.getProperty("user.home", "")),
        System.getenv());
  }

  /**
   * Returns the program's configuration folder.
   *
   * @param system the name of the operating system, as in {@code os.name}
   * @param home the user's home folder
   * @param environment variables of the process
   */
  public static Path of(String system, Path home, Map<String, String> environment) {
    String name = system.toLowerCase(Locale.ROOT);
    if (name.contains("win") && !name.contains("darwin")) {
      String roaming = environment.getOrDefault("APPDATA", "");
      return (roaming.isEmpty() ? home.resolve("AppData").resolve("Roaming") : Path.of(roaming))
          .resolve(NAME);
    }
    if (name.contains("mac") || name.contains("darwin")) {
      return home.resolve("Library").resolve("Application Support").resolve(NAME);
    }
    String configured = environment.getOrDefault("XDG_CONFIG_HOME", "");
    return (configured.isEmpty() ? home.resolve(".config") : Path.of(configured)).resolve(NAME);
  }
}
