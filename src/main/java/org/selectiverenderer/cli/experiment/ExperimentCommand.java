package org.selectiverenderer.cli.experiment;

import java.util.List;
import org.selectiverenderer.command.CliCommand;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;
import picocli.CommandLine.Command;

@Command(
    name = "experiment",
    description = "Creates studies, runs sessions, collects and analyses answers.",
    footer = {
      "  ./selective-renderer experiment new mystudy",
      "  ./selective-renderer experiment run mystudy/study.json --participant 001",
      "  ./selective-renderer experiment view session.csv --plot session.svg",
      "  ./selective-renderer experiment analyse r.csv --format html --output r.html"
    })
public final class ExperimentCommand extends CliCommand {
  public ExperimentCommand(Console console) {
    super(console);
  }

  @Override
  public List<CliCommand> subcommands() {
    return List.of(
        new ExperimentNewCommand(console()),
        new ExperimentCheckCommand(console()),
        new ExperimentPlanCommand(console()),
        new ExperimentPreviewCommand(console()),
        new ExperimentRunCommand(console()),
        new ExperimentStatusCommand(console()),
        new ExperimentCollectCommand(console()),
        new ExperimentBidsCommand(console()),
        new ExperimentExportCommand(console()),
        new ExperimentArchiveCommand(console()),
        new ExperimentPaperCommand(console()),
        new ExperimentThresholdCommand(console()),
        new ExperimentViewCommand(console()),
        new ExperimentAnalyseCommand(console()),
        new ExperimentAnovaCommand(console()),
        new ExperimentSimulateCommand(console()));
  }

  @Override
  public ExitStatus run() {
    throw CommandException.usage("no experiment command given; experiment --help lists them");
  }
}
