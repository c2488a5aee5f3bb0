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
    return of(System.getProperty("os.name", ""), HomeFolder.ofUser(), System.getenv());
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
    if (name.contains("mac") || name.contains("darwin")) {
      return home.resolve("Library").resolve("Application Support").resolve(NAME);
    }
    boolean windows = name.contains("win");
    Path usual = windows ? home.resolve("AppData").resolve("Roaming") : home.resolve(".config");
    Path named = Path.of(environment.getOrDefault(windows ? "APPDATA" : "XDG_CONFIG_HOME", ""));
    // A relative one is to be ignored (XDG): a stranger's repository could bring such a folder.
    return (named.isAbsolute() ? named : usual).resolve(NAME);
  }
}
