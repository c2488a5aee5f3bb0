package org.selectiverenderer.cli.experiment;

import java.io.IOException;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.command.CliCommand;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.command.output.CommandFileCheck;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;
import org.selectiverenderer.command.trust.TrustOption;
import org.selectiverenderer.study.definition.Study;
import org.selectiverenderer.study.rehearsal.PlanReport;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.session.StudyPlan;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

@Command(
    name = "plan",
    description = {
      "Shows who comes next, and the group and the order of trials of each participant to come.",
      "The plan tells the conditions, also of a blind study."
    },
    footer = {
      "  ./selective-renderer experiment plan mystudy",
      "  ./selective-renderer experiment plan mystudy --format html \\",
      "      --output plan.html"
    })
final class ExperimentPlanCommand extends CliCommand {
  private static final int MOST = 10_000;

  private enum Format {
    text,
    csv,
    html
  }

  @Mixin private StudyArgument study = new StudyArgument();

  @Mixin private TrustOption trust = new TrustOption();

  @Option(
      names = "--participants",
      paramLabel = "N",
      description = "number of places to show (default: the study's participants)")
  private @Nullable Integer participants;

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
    if (participants != null && (participants < 1 || participants > MOST)) {
      throw CommandException.usage("--participants must be a whole number from 1 to " + MOST);
    }
    output.check(new CommandFileCheck());
    ProblemCollector problems = new ProblemCollector(console()::problem);
    Optional<LoadedStudy> material = study.read(trust, console(), problems);
    if (material.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    Study planned = material.get().study();
    StudyPlan plan =
        StudyPlan.of(
            planned, participants != null ? participants : Math.min(MOST, planned.participants()));
    plan.faults()
        .forEach(fault -> problems.error(SourceLocation.of(planned.file().toString()), fault));
    output.write(
        switch (format) {
          case text -> PlanReport.text(plan);
          case csv -> PlanReport.csv(plan);
          case html -> PlanReport.html(plan);
        },
        console());
    return ExitStatus.of(problems);
  }
}
