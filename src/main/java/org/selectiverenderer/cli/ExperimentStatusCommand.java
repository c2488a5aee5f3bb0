package org.selectiverenderer.cli;

import java.io.IOException;
import java.util.Optional;
import org.selectiverenderer.experiment.session.StudyMaterial;
import org.selectiverenderer.experiment.session.StudyStatus;
import org.selectiverenderer.x3d.Problems;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

@Command(
    name = "status",
    description = "Tells who is done, how the groups stand, and what is missing.",
    footer = "  ./selective-renderer experiment status mystudy")
final class ExperimentStatusCommand extends CliCommand {
  private enum Format {
    text,
    json
  }

  @Mixin private StudyArgument study = new StudyArgument();

  @Option(
      names = "--format",
      defaultValue = "text",
      description = "${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE})")
  private Format format = Format.text;

  ExperimentStatusCommand(Console console) {
    super(console);
  }

  @Override
  ExitStatus run() throws IOException {
    Problems problems = new Problems(console()::problem);
    Optional<StudyMaterial> material = study.read(problems);
    if (material.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    StudyStatus status = StudyStatus.of(material.get());
    console().out().print(format == Format.json ? status.json() : status.text());
    return ExitStatus.of(problems);
  }
}
