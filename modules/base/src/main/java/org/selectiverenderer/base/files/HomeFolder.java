package org.selectiverenderer.base.files;

import java.nio.file.FileSystems;
import java.nio.file.Path;

/** Finds the user's home folder. */
public final class HomeFolder {
  private HomeFolder() {}

  /** Returns the home folder of the user who runs this process; it is absolute. */
  public static Path ofUser() {
    return of(System.getProperty("user.home", ""));
  }

  /**
   * Returns a home folder. Java names it "?" for an account that the system does not know, as many
   * containers have. Taken as it is, that is a folder in the current directory, where a stranger's
   * repository could bring settings and answers to questions of trust; so it is one beside the
   * system's own folders, which nobody but the administrator makes.
   *
   * @param property the system property {@code user.home}
   */
  static Path of(String property) {
    Path home = Path.of(property.equals("?") ? "" : property);
    return home.isAbsolute()
        ? home
        : FileSystems.getDefault().getRootDirectories().iterator().next().resolve("no-home");
  }
}
