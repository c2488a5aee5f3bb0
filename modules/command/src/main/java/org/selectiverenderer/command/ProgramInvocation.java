package org.selectiverenderer.command;

import java.util.Locale;
import java.util.Optional;
import java.util.Properties;
import java.util.regex.Pattern;

/**
 * The program's name as the user types it: {@code ./selective-renderer} in the source tree; without
 * {@code ./} where the program is installed, and on Windows.
 */
public final class ProgramInvocation {
  /** The system property that the launcher of an installed package sets. */
  private static final String INSTALLED = "selective-renderer.installed";

  /** The system property that the launchers of jpackage set. */
  private static final String BUNDLED = "jpackage.app-path";

  private static final Pattern RUN_WITHIN_QUOTES =
      Pattern.compile("[$`%!\"\\x{201c}\\x{201d}\\x{201e}]");

  /** Before a closing quote the last of them would quote that. */
  private static final Pattern TRAILING_BACKSLASHES = Pattern.compile("\\\\+$");

  private static final String HERE = "./" + ProgramVersion.PROGRAM;

  /** A serial port in examples; on Windows and macOS they have other names. */
  private static final String LINUX_PORT = "/dev/ttyUSB0";

  private ProgramInvocation() {}

  /**
   * Adapts a text with commands as typed in the source tree to this process's user. On Windows a
   * command that a backslash continues in the next line becomes one line. A serial port is named as
   * on the user's system.
   */
  public static String in(String text) {
    return in(text, System.getProperties());
  }

  /** Returns the program's name as this process's user types it. */
  public static String name() {
    return in(HERE);
  }

  /**
   * Quotes a word of a command line that the user is told to type, if that needs it: for a POSIX
   * shell, and on Windows for {@code cmd} and PowerShell alike. Control characters become question
   * marks.
   *
   * @return empty for a word of which one of the two shells of Windows would run a part or replace
   *     it by something else
   */
  public static Optional<String> quoted(String word) {
    return quoted(word, System.getProperties());
  }

  static Optional<String> quoted(String word, Properties properties) {
    String plain = word.replaceAll("[\\p{Cntrl}\\p{Cf}]", "?");
    if (!windows(properties)) {
      return Optional.of(
          plain.matches("[\\w@%+=:,./-]+") ? plain : "'" + plain.replace("'", "'\\''") + "'");
    }
    if (plain.matches("[\\p{L}\\p{N}_+=:./\\\\-]+")) {
      return Optional.of(plain);
    }
    // PowerShell takes curly quotes for straight ones.
    return RUN_WITHIN_QUOTES.matcher(plain).find()
        ? Optional.empty()
        : Optional.of('"' + TRAILING_BACKSLASHES.matcher(plain).replaceFirst("$0$0") + '"');
  }

  static String in(String text, Properties properties) {
    String lines = windows(properties) ? text.replaceAll(" \\\\\\R +", " ") : text;
    String ports = lines.replace(LINUX_PORT, serialPort(properties));
    return here(properties) ? ports : ports.replace(HERE, ProgramVersion.PROGRAM);
  }

  private static String serialPort(Properties properties) {
    if (windows(properties)) {
      return "COM3";
    }
    return properties.getProperty("os.name", "").toLowerCase(Locale.ROOT).startsWith("mac")
        ? "/dev/cu.usbserial-10"
        : LINUX_PORT;
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
