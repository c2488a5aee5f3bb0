package org.selectiverenderer.cli;

import java.util.List;
import picocli.CommandLine.Command;

@Command(
    name = "experiment",
    description = "Studies with participants: analysing their answers, planning new ones.",
    footer =
        "  ./selective-renderer experiment analyse responses.csv --format html --output report.html")
final class ExperimentCommand extends CliCommand {
  ExperimentCommand(Console console) {
    super(console);
  }

  @Override
  List<CliCommand> subcommands() {
    return List.of(
        new ExperimentAnalyseCommand(console()),
        new ExperimentAnovaCommand(console()),
        new ExperimentSimulateCommand(console()));
  }

  @Override
  ExitStatus run() {
    throw CommandFailure.usage("experiment needs a command of its own");
  }
}
