package org.selectiverenderer.cli;

import java.util.List;
import picocli.CommandLine.Command;

@Command(
    name = "experiment",
    description = "Studies, sessions and their results.",
    footer = {
      "  ./selective-renderer experiment view session.csv --plot session.svg",
      "  ./selective-renderer experiment analyse responses.csv --format html --output report.html"
    })
final class ExperimentCommand extends CliCommand {
  ExperimentCommand(Console console) {
    super(console);
  }

  @Override
  List<CliCommand> subcommands() {
    return List.of(
        new ExperimentViewCommand(console()),
        new ExperimentAnalyseCommand(console()),
        new ExperimentAnovaCommand(console()),
        new ExperimentSimulateCommand(console()));
  }

  @Override
  ExitStatus run() {
    throw CommandFailure.usage("which one? experiment --help lists what there is");
  }
}
