package org.selectiverenderer.app.studies;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.selectiverenderer.app.process.ProgramCommand;
import org.selectiverenderer.cli.experiment.ExperimentCommand;
import org.selectiverenderer.command.CliCommand;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;
import picocli.CommandLine;

class StudyCommandsTest {
  private static final StudyCommands STUDY = new StudyCommands(Path.of("my study", "study.json"));

  static Stream<ProgramCommand> all() {
    SessionRequest.Options everything = new SessionRequest.Options(true, true, true, true);
    return Stream.of(
        StudyCommands.create(Path.of("new"), Optional.of(Path.of("scene.x3d"))),
        STUDY.run(new SessionRequest("007", 2, true, false, Optional.of("el"), everything)),
        STUDY.run(
            new SessionRequest(
                "007", 1, false, true, Optional.empty(), SessionRequest.Options.USUAL)),
        STUDY.plan(),
        STUDY.planPage(Path.of("plan.html")),
        STUDY.status(true),
        STUDY.check(),
        STUDY.preview(Path.of("preview")),
        STUDY.previewFrom("form", 10),
        STUDY.collect(Path.of("results"), true),
        STUDY.analyse(Path.of("results"), false),
        STUDY.analyse(Path.of("results"), true),
        StudyCommands.copy(Path.of("new"), "change-blindness"));
  }

  /** Everything that the commands do, and nothing that they cannot. */
  @ParameterizedTest
  @MethodSource("all")
  void theProgramKnowsEachCommand(ProgramCommand command) {
    CommandLine experiment = line(new ExperimentCommand(console(), study -> ExitStatus.DONE));
    List<String> words = command.words();
    assertThat(words.get(0)).isEqualTo("experiment");
    experiment.parseArgs(words.subList(1, words.size()).toArray(String[]::new));
  }

  private static CommandLine line(CliCommand command) {
    CommandLine line = new CommandLine(command);
    command
        .subcommands()
        .forEach(
            each -> {
              CommandLine sub = line(each);
              line.addSubcommand(sub.getCommandName(), sub);
            });
    return line;
  }

  private static Console console() {
    return new Console(System.out, System.err, false);
  }

  @Test
  void aCommandLineIsQuotedForTheShell() {
    assertThat(STUDY.check().line().orElseThrow())
        .contains("experiment check")
        .matches(".*['\"]my study.study.json['\"]");
  }
}
