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
import picocli.CommandLine.Option;

@Command(
    name = "status",
    description =
        "Shows who is done, how full the groups are, and what is missing; of a blind study no"
            + " conditions.",
    footer = "  ./selective-renderer experiment status mystudy")
final class ExperimentStatusCommand extends CliCommand {
  @Mixin private StudyArgument study = new StudyArgument();

  @Mixin private TrustOption trust = new TrustOption();

  @Mixin private FormatOption format = new FormatOption();

  @Option(
      names = "--show-condition",
      description = "shows conditions and the sizes of the groups, even if the study is blind")
  private boolean showCondition;

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
    StudyStatus known = StudyStatus.of(material.get(), problems);
    boolean blind = material.get().study().course().blind() && !showCondition;
    StudyStatus status = blind ? known.blinded() : known;
    console().out().print(format.json() ? status.json() : status.text());
    return ExitStatus.of(problems);
  }
}
