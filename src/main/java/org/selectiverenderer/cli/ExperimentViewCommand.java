package org.selectiverenderer.cli;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.experiment.headlog.AnalysisFormats;
import org.selectiverenderer.experiment.headlog.Bids;
import org.selectiverenderer.experiment.headlog.HeadLog;
import org.selectiverenderer.experiment.headlog.HeadLogAnalysis;
import org.selectiverenderer.experiment.headlog.HeadLogPlot;
import org.selectiverenderer.experiment.headlog.HeadLogReader;
import org.selectiverenderer.x3d.Problems;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

@Command(
    name = "view",
    description = {
      "Says what a participant looked at: which objects, when and for how long, and how much of each"
          + " room came into view at all.",
      "LOG is what run --head-log wrote, with its description beside it."
    },
    footer = {
      "  ./selective-renderer run scenes/trashcan.x3d --head-log session.csv",
      "  ./selective-renderer experiment view session.csv --plot session.svg"
    })
final class ExperimentViewCommand extends CliCommand {
  private enum Format {
    text,
    json
  }

  @Parameters(paramLabel = "LOG", description = "the head log (.csv)")
  private Path log = Path.of("");

  @Option(
      names = "--format",
      defaultValue = "text",
      description = "${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE})")
  private Format format = Format.text;

  @Option(
      names = "--plot",
      paramLabel = "F.svg",
      description = "draws the session from above and as a timeline")
  private @Nullable Path plot;

  @Option(
      names = "--bids",
      paramLabel = "DIR",
      description = "writes it as BIDS motion data into a folder")
  private @Nullable Path bids;

  @Option(
      names = "--subject",
      defaultValue = "01",
      paramLabel = "LABEL",
      description =
          "the participant's label in BIDS, letters and digits (default: ${DEFAULT-VALUE})")
  private String subject = "01";

  ExperimentViewCommand(Console console) {
    super(console);
  }

  @Override
  ExitStatus run() throws IOException {
    OutputFile.check("--plot", plot, ".svg");
    if (!subject.matches("[0-9A-Za-z]+")) {
      throw CommandFailure.usage("--subject is a label of letters and digits");
    }
    Problems problems = new Problems(console()::problem);
    Optional<HeadLog> read = HeadLogReader.read(log, problems);
    if (read.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    HeadLogAnalysis analysis = HeadLogAnalysis.of(read.get());
    console()
        .out()
        .print(
            format == Format.json
                ? AnalysisFormats.json(analysis) + "\n"
                : AnalysisFormats.text(analysis));
    if (plot != null) {
      Files.writeString(plot, HeadLogPlot.svg(analysis), StandardCharsets.UTF_8);
    }
    if (bids != null) {
      console().message("BIDS motion data: " + Bids.write(read.get(), bids, subject));
    }
    return problems.any() ? ExitStatus.PROBLEMS : ExitStatus.DONE;
  }
}
