package org.selectiverenderer.doctor.probe;

import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import org.selectiverenderer.doctor.Diagnosis;

/** Checks the Java that runs the program. */
final class JavaProbe {
  /** The size of the heap in MB that is enough for the thesis's apartment and the enricher. */
  private static final long ENOUGH_MB = 500;

  private static final String ARCHIVE = "-XX:SharedArchiveFile=";

  private JavaProbe() {}

  static void run(Consumer<Diagnosis> found) {
    long heap = Runtime.getRuntime().maxMemory() >> 20;
    String java =
        "%s, %s (%s), in %s"
            .formatted(
                System.getProperty("java.runtime.version", "unknown"),
                System.getProperty("java.vm.name", "unknown"),
                System.getProperty("java.vendor", "unknown"),
                System.getProperty("java.home", "unknown"));
    found.accept(Diagnosis.ok("Java", java));
    String memory = "%,d MB at most".formatted(heap);
    found.accept(
        heap < ENOUGH_MB
            ? Diagnosis.warning(
                "Java's memory",
                memory,
                "large scenes need more: SELECTIVE_RENDERER_JAVA_OPTS=-Xmx1g")
            : Diagnosis.ok("Java's memory", memory));
  }

  /** Checks the class data sharing archive that the launcher makes. */
  static void archive(Consumer<Diagnosis> found) {
    Optional<Path> archive =
        ManagementFactory.getRuntimeMXBean().getInputArguments().stream()
            .filter(flag -> flag.startsWith(ARCHIVE))
            .map(flag -> Path.of(flag.substring(ARCHIVE.length())))
            .findFirst();
    if (archive.filter(Files::isReadable).isPresent()) {
      found.accept(Diagnosis.ok("class archive", archive.get().toString()));
    } else if (archive.isEmpty() && !launcherMakesOne()) {
      found.accept(
          Diagnosis.ok("class archive", "none, as the launcher of this system makes none"));
    } else {
      found.accept(
          Diagnosis.warning(
              "class archive",
              archive.map(file -> file + " is not there").orElse("none is used"),
              "commands start more slowly: begin the program by its launcher, and let it write to its"
                  + " folder target"));
    }
  }

  /**
   * Returns whether the launcher makes an archive: only the script for Linux and macOS does, not
   * that for Windows or a package's.
   */
  private static boolean launcherMakesOne() {
    return System.getProperty("jpackage.app-path") == null
        && !System.getProperty("os.name", "").toLowerCase(Locale.ROOT).startsWith("windows");
  }
}
