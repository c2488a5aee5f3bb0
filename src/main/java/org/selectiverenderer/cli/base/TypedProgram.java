package org.selectiverenderer.cli.base;

import java.util.Locale;
import java.util.Properties;

/**
 * How a user types the program's name: with the launcher's folder among the sources; without it
 * where the program is installed, and on Windows, whose command line knows no such folder.
 */
public final class TypedProgram {
  /** Set by the launcher where it lies in a package. */
  private static final String INSTALLED = "selective-renderer.installed";

  /** Set by the launchers of jpackage. */
  private static final String BUNDLED = "jpackage.app-path";

  private static final String HERE = "./" + ProgramVersion.PROGRAM;

  private TypedProgram() {}

  /**
   * A text with commands as they are typed among the sources, for this process's user. A command
   * that a backslash continues in the next line is one line on Windows, whose command line knows no
   * such sign.
   */
  public static String in(String text) {
    return in(text, System.getProperties());
  }

  /** The program's name, for this process's user. */
  public static String name() {
    return in(HERE);
  }

  static String in(String text, Properties properties) {
    String lines = windows(properties) ? text.replaceAll(" \\\\\\R +", " ") : text;
    return here(properties) ? lines : lines.replace(HERE, ProgramVersion.PROGRAM);
  }

  private static boolean here(Properties properties) {
    return properties.getProperty(INSTALLED) == null
        && properties.getProperty(BUNDLED) == null
        && !windows(properties);
  }

  private static boolean windows(Properties properties) {
    return properties.getProperty("os.name", "").toLowerCase(Locale.ROOT).startsWith("windows");
  }
}
