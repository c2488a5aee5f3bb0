package org.selectiverenderer;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/**
 * Rules for the sources of all tests, of the fixtures that modules share and of {@code
 * modules/testing}.
 */
class TestSourcesTest {
  /** Pauses of a thread, in Java and in the Python of the scripts. */
  private static final Pattern PAUSE =
      Pattern.compile(
          "\\bsleep\\s*\\(|\\bpark(?:Nanos|Until)?\\s*\\(|\\bonSpinWait\\s*\\("
              + "|\\b[rR]obot(?:\\(\\))?\\.delay\\s*\\(");

  /**
   * The one class that awaits conditions, the pauses for which X11 gives no signal, and a
   * benchmark, which rests between measurements.
   */
  private static final Set<String> MAY_PAUSE =
      Set.of("Eventually.java", "DisplaySettling.java", "BigSceneBenchmark.java");

  private static final Pattern FOLDER =
      Pattern.compile("(?:.+/)?src/(?:test|fixtures)/.+|modules/testing/src/.+");

  @Test
  void nothingPausesExceptWhereConditionsAreAwaited() throws IOException {
    List<String> found = new ArrayList<>();
    List<Path> sources = sources();
    for (Path source : sources) {
      String text = Files.readString(source);
      Matcher pause = PAUSE.matcher(text);
      while (!MAY_PAUSE.contains(source.getFileName().toString()) && pause.find()) {
        long line = text.substring(0, pause.start()).lines().count();
        found.add(source + ":" + line + " " + pause.group());
      }
    }
    assertThat(sources).hasSizeGreaterThan(500);
    assertThat(found)
        .as("pauses; org.selectiverenderer.testing.Eventually awaits conditions")
        .isEmpty();
  }

  /** A module's tests find no files that another module's build has made. */
  @Test
  void noModuleReadsTheBuildOfAnother() throws IOException {
    Pattern built = Pattern.compile("\"(?:modules|tools)/[\\w-]+/target|\"\\.\\./[\\w./-]*target");
    List<String> found = new ArrayList<>();
    for (Path source : sources()) {
      built
          .matcher(Files.readString(source))
          .results()
          .forEach(it -> found.add(source + it.group()));
    }
    assertThat(found).isEmpty();
  }

  private static List<Path> sources() throws IOException {
    List<Path> sources = new ArrayList<>();
    for (String root : List.of("src", "modules", "tools")) {
      try (Stream<Path> files = Files.walk(Path.of(root))) {
        files
            .filter(file -> file.toString().matches(".+\\.(java|py)"))
            .filter(file -> FOLDER.matcher(file.toString().replace('\\', '/')).matches())
            .sorted()
            .forEach(sources::add);
      }
    }
    return sources;
  }
}
