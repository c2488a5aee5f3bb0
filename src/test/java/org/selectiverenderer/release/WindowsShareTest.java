package org.selectiverenderer.release;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** The lists of tests that {@code .ci/windows} reads name tests that there are, and say why. */
class WindowsShareTest {
  private static final Path SHARE = Path.of(".ci/windows-share");
  private static final Path EXCLUSIONS = Path.of(".ci/windows-exclusions");

  private static List<String> lines(Path list) throws IOException {
    try (Stream<String> lines = Files.lines(list)) {
      return lines.filter(line -> !line.isBlank() && !line.startsWith("#")).toList();
    }
  }

  /** Returns the names of all test classes, as {@code base.files.FileFinderTest}. */
  private static List<String> classes() throws IOException {
    try (Stream<Path> files =
        Stream.of("modules", "tools", "src").map(Path::of).flatMap(WindowsShareTest::walk)) {
      return files
          .map(file -> file.toString().replace('\\', '/'))
          .filter(file -> file.contains("/test/java/") && file.endsWith("Test.java"))
          .map(file -> file.replaceAll(".*/test/java/org/selectiverenderer/|\\.java$", ""))
          .map(file -> file.replace('/', '.'))
          .toList();
    }
  }

  private static Stream<Path> walk(Path folder) {
    try {
      return Files.walk(folder);
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  @Test
  void eachLineOfTheShareNamesTestsAndSaysWhy() throws IOException {
    List<String> classes = classes();
    assertThat(lines(SHARE))
        .isNotEmpty()
        .allSatisfy(
            line -> {
              String[] words = line.split(" +", 2);
              assertThat(words).as("a pattern and a reason").hasSize(2);
              assertThat(classes).anyMatch(Pattern.compile(words[0]).asMatchPredicate());
            });
  }

  @Test
  void eachExclusionNamesATestAndSaysWhy() throws IOException {
    List<String> classes = classes();
    assertThat(lines(EXCLUSIONS))
        .allSatisfy(
            line -> {
              String[] words = line.split(" +", 2);
              assertThat(words).as("a test and a reason").hasSize(2);
              String name = words[0].replaceFirst("#.*", "");
              assertThat(classes).anyMatch(each -> ("." + each).endsWith("." + name));
            });
  }
}
