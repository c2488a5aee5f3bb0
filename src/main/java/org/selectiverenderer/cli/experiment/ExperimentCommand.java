package org.selectiverenderer.cli.experiment;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.command.CliCommand;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

@Command(
    name = "experiment",
    description = {
      "Creates studies, runs sessions, collects and analyses answers.",
      "Without a command it opens the study window."
    },
    footer = {
      "  ./selective-renderer experiment",
      "  ./selective-renderer experiment new mystudy",
      "  ./selective-renderer experiment run mystudy/study.json --participant 001",
      "  ./selective-renderer experiment view session.csv --plot session.svg",
      "  ./selective-renderer experiment analyse r.csv --format html --output r.html"
    })
public final class ExperimentCommand extends CliCommand {
  /** Opens the study window and waits until it is closed. */
  @FunctionalInterface
  public interface Window {
    /**
     * @param study to open; empty for none
     * @throws IOException with one line if there is no display
     */
    ExitStatus open(Optional<Path> study) throws IOException;
  }

  @Option(
      names = "--study",
      paramLabel = "STUDY.json",
      description = "study that the window opens: its file, or the folder that contains study.json")
  private @Nullable Path study;

  private final Window window;

  public ExperimentCommand(Console console, Window window) {
    super(console);
    this.window = window;
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
        new ExperimentSimulateCommand(console()),
        new ExperimentReplicateCommand(console()));
  }

  @Override
  public ExitStatus run() throws IOException {
    return window.open(Optional.ofNullable(study));
  }
}
