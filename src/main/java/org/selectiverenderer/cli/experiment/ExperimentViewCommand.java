package org.selectiverenderer.cli.experiment;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.cli.option.FormatOption;
import org.selectiverenderer.command.CliCommand;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;
import org.selectiverenderer.command.output.OutputFile;
import org.selectiverenderer.study.dataset.RecordedRun;
import org.selectiverenderer.study.dataset.RecordedSession;
import org.selectiverenderer.study.headlog.BidsMotionFiles;
import org.selectiverenderer.study.headlog.HeadLog;
import org.selectiverenderer.study.headlog.HeadLogAnalysis;
import org.selectiverenderer.study.headlog.HeadLogPlot;
import org.selectiverenderer.study.headlog.HeadLogReader;
import org.selectiverenderer.study.headlog.HeadLogReport;
import org.selectiverenderer.study.headlog.SwitchSightings;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

@Command(
    name = "view",
    description = {
      "Shows what a participant looked at: which objects, when and for how long, and "
          + "how much of each room came into view at all.",
      "LOG is a file that run --head-log or a session wrote; its description lies beside it."
    },
    footer = {
      "  ./selective-renderer run scenes/trashcan.x3d --head-log session.csv",
      "  ./selective-renderer experiment view session.csv --plot session.svg"
    })
final class ExperimentViewCommand extends CliCommand {
  @Parameters(paramLabel = "LOG", description = "head log (.csv)")
  private Path log = Path.of("");

  @Mixin private FormatOption format = new FormatOption();

  @Option(
      names = "--plot",
      paramLabel = "F.svg",
      description = "writes a drawing of the session, from above and as a time line")
  private @Nullable Path plot;

  @Option(
      names = "--timeline",
      paramLabel = "F.jsonl",
      description =
          "time line that the same run wrote (run --timeline); tells which objects were seen as "
              + "they changed (default: what the journal of the log's session tells of it)")
  private @Nullable Path timeline;

  @Option(
      names = "--bids",
      paramLabel = "DIR",
      description = "writes the log as BIDS motion data into a folder")
  private @Nullable Path bids;

  @Option(
      names = "--subject",
      defaultValue = "01",
      paramLabel = "LABEL",
      description =
          "label of the participant in BIDS, letters and digits (default: ${DEFAULT-VALUE})")
  private String subject = "01";

  ExperimentViewCommand(Console console) {
    super(console);
  }

  @Override
  public ExitStatus run() throws IOException {
    OutputFile.check("--plot", plot, ".svg");
    if (!subject.matches("[0-9A-Za-z]+")) {
      throw CommandException.usage("--subject must consist of letters and digits");
    }
    ProblemCollector problems = new ProblemCollector(console()::problem);
    Optional<HeadLog> read = HeadLogReader.read(log, problems);
    if (read.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    HeadLogAnalysis analysis = HeadLogAnalysis.of(read.get());
    console().out().print(report(analysis, problems));
    if (plot != null) {
      OutputFile.writePrivate(plot, HeadLogPlot.svg(analysis));
    }
    if (bids != null) {
      console().message("BIDS motion data: " + BidsMotionFiles.write(read.get(), bids, subject));
    }
    return problems.any() ? ExitStatus.PROBLEMS : ExitStatus.DONE;
  }

  private String report(HeadLogAnalysis analysis, ProblemCollector problems) throws IOException {
    Optional<SwitchSightings> told = switches(problems);
    if (told.isEmpty()) {
      return format.json() ? HeadLogReport.json(analysis) : HeadLogReport.text(analysis);
    }
    SwitchSightings switches = told.get();
    return format.json()
        ? HeadLogReport.json(analysis, switches)
        : HeadLogReport.text(analysis) + "\n" + switches.text();
  }

  /** Returns the changes that the time line tells; else those of the session's journal, if any. */
  private Optional<SwitchSightings> switches(ProblemCollector problems) throws IOException {
    if (timeline != null) {
      return Optional.of(SwitchSightings.read(timeline, problems));
    }
    try {
      return RecordedSession.runOf(log, problems)
          .map(RecordedRun::switches)
          .filter(switches -> !switches.changes().isEmpty());
    } catch (IOException e) {
      problems.warning(
          SourceLocation.of(log.toString()),
          "the changes that were seen are left out, as the session's journal cannot be read: "
              + e.getMessage());
      return Optional.empty();
    }
  }
}
