package org.selectiverenderer.cli.experiment;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.cli.base.CliCommand;
import org.selectiverenderer.cli.output.CommandFiles;
import org.selectiverenderer.cli.output.Console;
import org.selectiverenderer.cli.output.ExitStatus;
import org.selectiverenderer.statistics.anova.AnovaOptions;
import org.selectiverenderer.statistics.data.Responses;
import org.selectiverenderer.statistics.data.ResponsesReader;
import org.selectiverenderer.statistics.data.Roster;
import org.selectiverenderer.statistics.report.StudyReport;
import org.selectiverenderer.statistics.study.MissingTables;
import org.selectiverenderer.statistics.study.StudyAnalysis;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

@Command(
    name = "analyse",
    description = {
      "Analyses answers about remembered objects: d', log beta and c of each participant, analyses"
          + " of variance of each area at three levels of confidence.",
      "The file has the columns participant,condition,area,object,consistency,present,response,"
          + "confidence."
    },
    footer =
        "  ./selective-renderer experiment analyse responses.csv --format html --output"
            + " report.html")
final class ExperimentAnalyseCommand extends CliCommand {
  private enum Format {
    text,
    json,
    html,
    tidy,
    wide
  }

  @Parameters(paramLabel = "RESPONSES.csv", description = "table of the answers (.csv)")
  private Path responses = Path.of("");

  @Option(
      names = "--participants",
      paramLabel = "P.csv",
      description =
          "table of the participants, with the columns participant[,condition]; answers "
              + "of others are left out")
  private @Nullable Path participants;

  @Option(
      names = "--counterbalanced",
      description =
          "takes objects that are present for some participants and absent for others as meant")
  private boolean counterbalanced;

  @Mixin private ScoringChoices scoring = new ScoringChoices();
  @Mixin private AnovaChoices choices = new AnovaChoices();

  @Option(
      names = "--format",
      defaultValue = "text",
      description =
          "format of the report: ${COMPLETION-CANDIDATES}; tidy and wide are CSV of "
              + "the scores (default: ${DEFAULT-VALUE})")
  private Format format = Format.text;

  @Mixin private ReportOutput output = new ReportOutput();

  ExperimentAnalyseCommand(Console console) {
    super(console);
  }

  @Override
  public ExitStatus run() throws IOException {
    AnovaOptions options = choices.options();
    output.check(new CommandFiles().reads("", responses).reads("--participants", participants));
    Problems problems = new Problems(console()::problem);
    Optional<Roster> roster = Optional.empty();
    if (participants != null) {
      roster = Roster.read(participants, problems);
      if (roster.isEmpty()) {
        return ExitStatus.PROBLEMS;
      }
    }
    Optional<Responses> found = ResponsesReader.read(responses, roster, counterbalanced, problems);
    if (found.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    StudyAnalysis study = StudyAnalysis.of(found.get(), scoring.scoring(), options);
    MissingTables.tell(study, problems);
    output.write(
        switch (format) {
          case text -> StudyReport.text(study);
          case json -> StudyReport.json(study);
          case html -> StudyReport.html(study);
          case tidy -> StudyReport.tidyCsv(study);
          case wide -> StudyReport.wideCsv(study);
        },
        console());
    return ExitStatus.of(problems);
  }
}
