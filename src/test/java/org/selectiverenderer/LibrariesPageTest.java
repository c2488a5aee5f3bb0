package org.selectiverenderer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * docs/libraries.md shows the consumers' projects as they are, and these do what they say: here on
 * the classes of the build, on the libraries' jars in {@code packaging/libraries/check}.
 */
class LibrariesPageTest {
  private static final Path PAGE = Path.of("docs/libraries.md");
  private static final Path CONSUMERS = Path.of("packaging/libraries/consumers");

  /** Absolute, since the examples run in folders of their own. */
  private static final String CLASS_PATH =
      Arrays.stream(System.getProperty("java.class.path").split(File.pathSeparator))
          .map(entry -> Path.of(entry).toAbsolutePath().toString())
          .collect(Collectors.joining(File.pathSeparator));

  @ParameterizedTest
  @CsvSource({
    "control, WalkToTheDesk",
    "validation, CheckScenes",
    "statistics, ThreeGroups",
  })
  void thePageShowsTheExampleAndWhatItPrints(String library, String example) throws IOException {
    Path consumer = CONSUMERS.resolve(library);
    int named = read(PAGE).indexOf("class " + example + " ");
    assertThat(named).as("%s shows the class %s", PAGE, example).isPositive();
    hold("java", read(PAGE).lastIndexOf("```java\n", named), read(source(consumer, example)));
    hold(
        "text",
        read(PAGE).indexOf("class " + example + " "),
        read(consumer.resolve("expected.txt")));
  }

  @Test
  void thePageShowsTheSceneThatIsChecked() throws IOException {
    hold("xml", 0, read(CONSUMERS.resolve("validation/office.x3d")));
  }

  /**
   * Holds the next block of code of a language to what it should be; {@code mvn test
   * -Dtest=LibrariesPageTest -Dreports.update=true} writes it anew.
   */
  private static void hold(String language, int from, String expected) throws IOException {
    String page = read(PAGE);
    String fence = "```" + language + "\n";
    int begin = page.indexOf(fence, from);
    assertThat(begin).as("a block of %s in %s", language, PAGE).isNotNegative();
    int start = begin + fence.length();
    int end = page.indexOf("```\n", start);
    if (Boolean.getBoolean("reports.update")) {
      Files.writeString(PAGE, page.substring(0, start) + expected + page.substring(end));
    } else {
      assertThat(page.substring(start, end))
          .as("%s; mvn test -Dtest=LibrariesPageTest -Dreports.update=true writes it anew", PAGE)
          .isEqualTo(expected);
    }
  }

  @ParameterizedTest
  @CsvSource({
    "control, WalkToTheDesk, ''",
    "validation, CheckScenes, office.x3d",
    "statistics, ThreeGroups, ''",
  })
  void theExampleCompilesAndPrintsWhatItIsToPrint(
      String library, String example, String arguments, @TempDir Path folder) throws Exception {
    assumeTrue(
        !OS.WINDOWS.isCurrentOs() || ToolProvider.getSystemJavaCompiler() != null,
        "the Java that runs tests under Wine has no compiler");
    Path consumer = CONSUMERS.resolve(library);
    compile(consumer.resolve("src/main/java/example"), folder);
    List<String> command =
        new ArrayList<>(
            List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:TieredStopAtLevel=1",
                "-cp",
                folder + File.pathSeparator + CLASS_PATH,
                "example." + example));
    Stream.of(arguments.split(" ")).filter(argument -> !argument.isEmpty()).forEach(command::add);
    Process process =
        new ProcessBuilder(command)
            .directory(consumer.toFile())
            .redirectError(ProcessBuilder.Redirect.INHERIT)
            .start();
    String printed = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertThat(process.waitFor()).isZero();
    assertThat(printed.replace("\r\n", "\n")).isEqualTo(read(consumer.resolve("expected.txt")));
  }

  private static void compile(Path sources, Path folder) throws IOException {
    List<String> arguments =
        new ArrayList<>(
            List.of("--release", "17", "-proc:none", "-cp", CLASS_PATH, "-d", folder.toString()));
    try (DirectoryStream<Path> files = Files.newDirectoryStream(sources)) {
      files.forEach(file -> arguments.add(file.toString()));
    }
    ByteArrayOutputStream messages = new ByteArrayOutputStream();
    int status =
        ToolProvider.getSystemJavaCompiler()
            .run(null, messages, messages, arguments.toArray(new String[0]));
    assertThat(status).as(messages.toString(StandardCharsets.UTF_8)).isZero();
  }

  private static Path source(Path consumer, String example) {
    return consumer.resolve("src/main/java/example").resolve(example + ".java");
  }

  private static String read(Path file) throws IOException {
    return Files.readString(file).replace("\r\n", "\n");
  }
}
