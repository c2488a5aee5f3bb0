package org.selectiverenderer.base.files;

import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;

/** Finds the user's folder of caches by the convention of each operating system. */
public final class CacheFolder {
  private CacheFolder() {}

  /**
   * Returns the folder in which programs keep what they can make again, each in one of its own.
   *
   * @param system the name of the operating system, as in {@code os.name}
   * @param home the user's home folder
   * @param environment variables of the process
   */
  public static Path of(String system, Path home, Map<String, String> environment) {
    String name = system.toLowerCase(Locale.ROOT);
    if (name.contains("mac") || name.contains("darwin")) {
      return home.resolve("Library").resolve("Caches");
    }
    boolean windows = name.contains("win");
    Path usual = windows ? home.resolve("AppData").resolve("Local") : home.resolve(".cache");
    Path named = Path.of(environment.getOrDefault(variable(system), ""));
    return named.isAbsolute() ? named : usual; // A relative one is to be ignored (XDG).
  }

  /** Returns the environment variable that names the folder; on macOS {@code HOME} alone does. */
  public static String variable(String system) {
    String name = system.toLowerCase(Locale.ROOT);
    if (name.contains("mac") || name.contains("darwin")) {
      return "HOME";
    }
    return name.contains("win") ? "LOCALAPPDATA" : "XDG_CACHE_HOME";
  }
}
