package org.selectiverenderer.doctor.probe;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.charset.Charset;
import java.nio.charset.IllegalCharsetNameException;
import java.nio.charset.StandardCharsets;
import java.nio.charset.UnsupportedCharsetException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.selectiverenderer.base.platform.CpuInfo;
import org.selectiverenderer.doctor.Diagnosis;

/** Checks the computer, the operating system and the character encoding. */
final class SystemProbe {
  /** The file that names a Linux distribution (os-release(5)). */
  private static final Path RELEASE = Path.of("/etc/os-release");

  private static final String NAME = "PRETTY_NAME=";

  /**
   * The property by which the launcher of the packages for Windows says how it passes arguments.
   */
  private static final String ARGUMENTS = "selective-renderer.arguments";

  private static final String UNICODE = "unicode";

  private SystemProbe() {}

  static void run(Consumer<Diagnosis> found) throws IOException {
    String system = System.getProperty("os.name", "") + " " + System.getProperty("os.version", "");
    found.accept(
        Diagnosis.ok(
            "system",
            "%s, %s"
                .formatted(
                    release().map(name -> name + ", " + system).orElse(system),
                    System.getProperty("os.arch", "unknown"))));
    found.accept(
        Diagnosis.ok(
            "processor",
            "%s, %d cores for this program%s"
                .formatted(CpuInfo.name(), Runtime.getRuntime().availableProcessors(), memory())));
  }

  private static Optional<String> release() throws IOException {
    // On Windows the path would be one of the current drive, where anybody's file may lie.
    if (!System.getProperty("os.name", "").equals("Linux") || !Files.isReadable(RELEASE)) {
      return Optional.empty();
    }
    try (Stream<String> lines = Files.lines(RELEASE)) {
      return lines
          .filter(line -> line.startsWith(NAME))
          .map(line -> line.substring(NAME.length()).replace("\"", ""))
          .findFirst();
    }
  }

  private static String memory() {
    return ManagementFactory.getOperatingSystemMXBean()
            instanceof com.sun.management.OperatingSystemMXBean bean
        ? ", %,d MB of memory".formatted(bean.getTotalMemorySize() >> 20)
        : "";
  }

  static void language(Consumer<Diagnosis> found) {
    found.accept(
        language(
            System.getProperty("os.name", ""),
            UNICODE.equals(System.getProperty(ARGUMENTS))
                ? StandardCharsets.UTF_8.name()
                : System.getProperty("sun.jnu.encoding", Charset.defaultCharset().name())));
  }

  /**
   * Checks that names may be Greek.
   *
   * @param system the name of the operating system, as in {@code os.name}
   * @param names charset in which Java passes names of files to the system; on Windows, where files
   *     have their names in Unicode, it is the charset of the arguments of commands
   */
  static Diagnosis language(String system, String names) {
    boolean windows = system.toLowerCase(Locale.ROOT).startsWith("windows");
    String language =
        "%s, %s in %s, texts in %s"
            .formatted(
                Locale.getDefault(Locale.Category.DISPLAY).toLanguageTag(),
                windows ? "arguments of commands" : "names of files",
                names,
                Charset.defaultCharset());
    if (encodesGreek(names)) {
      return Diagnosis.ok("language", language);
    }
    return Diagnosis.warning(
        "language",
        language,
        windows
            ? "files with Greek names can be opened from file dialogs and as part of a folder, but not"
                + " as the argument of a command: choose Greek, or UTF-8, as the language for non-Unicode"
                + " programs (Settings, Time & language, Administrative language settings)"
            : "files with Greek names cannot be opened: set LC_ALL=C.UTF-8 or another language with"
                + " UTF-8");
  }

  /** Returns whether a charset can encode Greek; true for a charset unknown to Java. */
  static boolean encodesGreek(String charset) {
    try {
      return Charset.forName(charset).newEncoder().canEncode("Σκηνή");
    } catch (IllegalCharsetNameException | UnsupportedCharsetException e) {
      return true;
    }
  }
}
