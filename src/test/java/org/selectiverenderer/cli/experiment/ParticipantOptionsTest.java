package org.selectiverenderer.cli.experiment;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.study.definition.Study;
import org.selectiverenderer.study.definition.StudyReader;
import picocli.CommandLine;

/** What the experimenter is asked about an id that looks like another. */
class ParticipantOptionsTest {
  @TempDir Path folder;
  private final List<String> asked = new ArrayList<>();

  @BeforeEach
  void somebody() throws IOException {
    Files.createDirectories(folder.resolve("sub-001"));
    Files.writeString(folder.resolve("items.csv"), "area,schema,object,en\n");
    Files.writeString(
        folder.resolve("study.json"),
        """
        {"name": "One", "conditions": ["high"], "participants": 2,
         "questionnaires": [{"kind": "expectancy", "items": "items.csv"}]}
        """);
  }

  private String chosen(String answer, String... options) throws IOException {
    Study study =
        StudyReader.read(folder.resolve("study.json"), new ProblemCollector()).orElseThrow();
    ParticipantOptions choice = new ParticipantOptions();
    new CommandLine(CommandLine.Model.CommandSpec.forAnnotatedObject(choice)).parseArgs(options);
    return choice.of(
        study,
        false,
        question -> {
          asked.add(question);
          return Optional.of(answer);
        });
  }

  @Test
  void yesBeginsSomebodyNewAndAnythingElseDoesNot() throws IOException {
    assertThat(chosen("y", "--participant", "P1")).isEqualTo("P1");
    assertThat(asked)
        .containsExactly(
            "The ID P1 is new but resembles 001 of the same study. Is P1 a new person? [y/n] ");
    assertThatThrownBy(() -> chosen("", "--participant", "P1"))
        .isInstanceOf(CommandException.class)
        .hasMessage("no session was started; use --participant 001 for the participant of that ID");
  }

  @Test
  void nobodyIsAskedAboutAnIdThatIsClear() throws IOException {
    assertThat(chosen("n", "--participant", "001")).isEqualTo("001");
    assertThat(chosen("n", "--participant", "2")).isEqualTo("2");
    assertThat(chosen("n", "--participant", "1", "--new-participant")).isEqualTo("1");
    assertThat(chosen("n")).isEqualTo("002");
    assertThat(asked).isEmpty();
  }
}
