package org.selectiverenderer.pages;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.cli.CommandTestCase;
import org.selectiverenderer.cli.Main;
import org.selectiverenderer.testing.Eventually;
import org.selectiverenderer.testing.ShowsWindows;

/**
 * The commands of the stories do what the stories say. What a reader writes has names that begin
 * with {@code my-}; here that lies in a folder of the test's. Commands that take long, such as
 * sessions, are run with {@code -Dstories.all=true} alone. With {@code -Dreports.update=true} a
 * page gets what its commands print now in the place of what it shows otherwise, in full.
 */
@ShowsWindows
class StoriesTest extends CommandTestCase {
  private static final Path EXAMPLES = Path.of("docs/examples");

  @TempDir Path folder;
  private final List<Process> beside = new ArrayList<>();

  @ParameterizedTest
  @ValueSource(strings = {"researcher", "author", "ci"})
  void itsCommandsDoWhatItSays(String reader) throws IOException, InterruptedException {
    MarkdownPage page = MarkdownPage.read(Path.of("docs/story-" + reader + ".md"));
    List<StoryStep> steps = StoryStep.of(page);
    assertThat(steps).hasSizeGreaterThan(5);
    int status = 0;
    if (OS.WINDOWS.isCurrentOs()) {
      assumeFalse(reader.equals("researcher"), "it emulates a tracker, which Windows cannot");
    }
    for (StoryStep step : steps) {
      if (step.asksForStatus()) {
        assertThat(step.prints()).containsExactly(Integer.toString(status));
        status = 0;
        continue;
      }
      assertThat(status).as("exit status before %s\n%s", step.words(), messages()).isZero();
      if (!step.takesLong() || Boolean.getBoolean("stories.all")) {
        status = run(step, page.file());
      }
    }
    assertThat(status).as("%s\n%s", page.file(), messages()).isZero();
  }

  private int run(StoryStep step, Path page) throws IOException, InterruptedException {
    List<String> arguments =
        new ArrayList<>(step.words().stream().skip(1).map(this::placed).toList());
    if (step.words().get(0).equals("mkdir")) {
      Files.createDirectory(Path.of(arguments.get(0)));
      return 0;
    }
    if (step.words().get(0).equals(StoryStep.REPLACE)) {
      replace(arguments.get(0), arguments.get(1), Path.of(arguments.get(2)));
      return 0;
    }
    assertThat(step.isOurs()).as("a command of the program: %s", step.words()).isTrue();
    if (step.staysBeside()) {
      startBeside(arguments);
      return 0;
    }
    if (step.waitsForSomebody()) {
      if (step.is("enrich")) {
        assertThat(Path.of(arguments.get(1))).isRegularFile();
        return 0;
      }
      arguments.addAll(List.of("--offscreen", "--duration", "0.1"));
    }
    int status = execute(arguments.toArray(String[]::new));
    // Where the test's folder is named, from the root or from here, the reader has the name alone.
    String said =
        (messages() + printed())
            .replace('\\', '/')
            .replaceAll("[^\\s=\">]*" + folder.getFileName() + "/", "")
            .replaceAll("(?m) +$", "");
    int from = 0;
    for (String piece : step.prints()) {
      int at = said.indexOf(piece, from);
      if (at < 0 && Boolean.getBoolean("reports.update")) {
        replace(step.shown(), said.strip(), page);
        return status;
      }
      assertThat(at)
          .as(
              "%s shows for %s\n%s\nwhich is not in\n%s\n"
                  + "mvn test -Dtest=StoriesTest -Dreports.update=true writes it anew",
              page, step.words(), piece, said.substring(from))
          .isNotNegative();
      from = at + piece.length();
    }
    return status;
  }

  /** What a reader does in an editor. */
  private static void replace(String these, String by, Path file) throws IOException {
    String text = Files.readString(file);
    assertThat(text).contains(these);
    Files.writeString(file, text.replace(these, by));
  }

  /** A word with the reader's own files in the test's folder. */
  private String placed(String word) {
    return word.replaceAll(
        "(^|[:,])(my-)", "$1" + Matcher.quoteReplacement(folder.toString()) + "/$2");
  }

  private void startBeside(List<String> arguments) throws IOException {
    List<String> command =
        new ArrayList<>(
            List.of(
                ProcessHandle.current().info().command().orElse("java"),
                "-cp",
                System.getProperty("java.class.path"),
                Main.class.getName()));
    command.addAll(arguments);
    Path log = folder.resolve("beside.txt");
    Process process =
        new ProcessBuilder(command).redirectErrorStream(true).redirectOutput(log.toFile()).start();
    beside.add(process);
    Path link = Path.of(arguments.get(arguments.indexOf("--link") + 1));
    Eventually.await(
        link.toString(),
        () -> {
          assertThat(process.isAlive()).as(Files.readString(log)).isTrue();
          return Files.exists(link);
        });
  }

  @AfterEach
  void endWhatStaysBeside() throws InterruptedException {
    for (Process process : beside) {
      process.destroy();
      process.waitFor();
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"researcher", "author", "ci"})
  void filesThatItShowsAreThoseOfTheExamples(String reader) throws IOException {
    List<String> examples = new ArrayList<>();
    try (Stream<Path> files = Files.list(EXAMPLES)) {
      for (Path file : files.filter(Files::isRegularFile).toList()) {
        examples.add(Files.readString(file).replace("\r\n", "\n"));
      }
    }
    MarkdownPage page = MarkdownPage.read(Path.of("docs/story-" + reader + ".md"));
    for (MarkdownPage.Block block : page.blocks()) {
      if (!block.language().isEmpty()) {
        assertThat(examples)
            .as("a file of %s with\n%s", EXAMPLES, block.text())
            .anyMatch(example -> example.contains(block.text()));
      }
    }
  }
}
