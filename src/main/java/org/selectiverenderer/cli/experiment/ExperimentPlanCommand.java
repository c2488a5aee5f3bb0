package org.selectiverenderer.cli.experiment;

import java.io.IOException;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.command.CliCommand;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.command.output.CommandFileCheck;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;
import org.selectiverenderer.command.trust.TrustOption;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.session.StudyPlan;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

@Command(
    name = "plan",
    description = {
      "Shows the plan of a study before anybody comes: who is next, and for each place the group"
          + " and the order of areas or trials.",
      "It tells the conditions: keep it from experimenters who must not know them."
    },
    footer = {
      "  ./selective-renderer experiment plan mystudy",
      "  ./selective-renderer experiment plan mystudy --format csv --output plan.csv"
    })
final class ExperimentPlanCommand extends CliCommand {
  private enum Format {
    text,
    csv
  }

  @Mixin private StudyArgument study = new StudyArgument();

  @Mixin private TrustOption trust = new TrustOption();

  @Option(
      names = "--participants",
      paramLabel = "N",
      description = "number of places to show (default: the study's number of participants)")
  private @Nullable Integer count;

  @Option(
      names = "--format",
      paramLabel = "FORMAT",
      defaultValue = "text",
      description = "format of the plan: ${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE})")
  private Format format = Format.text;

  @Mixin private ReportOutputOption output = new ReportOutputOption();

  ExperimentPlanCommand(Console console) {
    super(console);
  }

  @Override
  public ExitStatus run() throws IOException {
    if (count != null && (count < 1 || count > 100_000)) {
      throw CommandException.usage("--participants must be a whole number from 1 to 100000");
    }
    output.check(new CommandFileCheck());
    ProblemCollector problems = new ProblemCollector(console()::problem);
    Optional<LoadedStudy> material = study.read(trust, console(), problems);
    if (material.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    StudyPlan plan =
        StudyPlan.of(
            material.get().study(), count == null ? material.get().study().participants() : count);
    output.write(format == Format.csv ? plan.csv(material.get().study()) : plan.text(), console());
    return ExitStatus.of(problems);
  }
}
