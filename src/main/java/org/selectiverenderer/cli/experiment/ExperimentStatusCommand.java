package org.selectiverenderer.cli.experiment;

import java.io.IOException;
import java.util.Optional;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.cli.option.FormatOption;
import org.selectiverenderer.command.CliCommand;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;
import org.selectiverenderer.command.trust.TrustOption;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.session.StudyStatus;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

@Command(
    name = "status",
    description = "Shows who is done, how full the groups are, and what is missing.",
    footer = "  ./selective-renderer experiment status mystudy")
final class ExperimentStatusCommand extends CliCommand {
  @Mixin private StudyArgument study = new StudyArgument();

  @Mixin private TrustOption trust = new TrustOption();

  @Mixin private FormatOption format = new FormatOption();

  ExperimentStatusCommand(Console console) {
    super(console);
  }

  @Override
  public ExitStatus run() throws IOException {
    ProblemCollector problems = new ProblemCollector(console()::problem);
    Optional<LoadedStudy> material = study.read(trust, console(), problems);
    if (material.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    StudyStatus status = StudyStatus.of(material.get(), problems);
    console().out().print(format.json() ? status.json() : status.text());
    return ExitStatus.of(problems);
  }
}
