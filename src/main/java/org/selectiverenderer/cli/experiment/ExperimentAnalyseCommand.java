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
import org.selectiverenderer.statistics.report.Provenance;
import org.selectiverenderer.statistics.report.StudyReport;
import org.selectiverenderer.statistics.study.FamilyCorrection;
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
    footer = "  ./selective-renderer experiment analyse r.csv --format html --output r.html")
final class ExperimentAnalyseCommand extends CliCommand {
  private enum Format {
    text,
    json,
    html,
    tidy,
    wide
  }

  private enum Family {
    none,
    holm,
    fdr
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
      description = "accepts that objects are present for some participants and absent for others")
  private boolean counterbalanced;

  @Mixin private ScoringChoices scoring = new ScoringChoices();
  @Mixin private SphericityOption sphericity = new SphericityOption();
  @Mixin private AnovaChoices choices = new AnovaChoices();
  @Mixin private PriorChoices prior = new PriorChoices();

  @Option(
      names = "--format",
      paramLabel = "FORMAT",
      defaultValue = "text",
      description =
          "format of the report: ${COMPLETION-CANDIDATES}; tidy and wide are CSV of "
              + "the scores (default: ${DEFAULT-VALUE})")
  private Format format = Format.text;

  @Option(
      names = "--family",
      paramLabel = "METHOD",
      defaultValue = "none",
      description =
          "correction of p over all effects, measures and areas of a level of confidence:"
              + " ${COMPLETION-CANDIDATES} (Holm 1979; Benjamini and Hochberg 1995) (default:"
              + " ${DEFAULT-VALUE})")
  private Family family = Family.none;

  @Mixin private ReportDate date = new ReportDate();
  @Mixin private StudyOutputs outputs = new StudyOutputs();
  @Mixin private ReportOutput output = new ReportOutput();

  ExperimentAnalyseCommand(Console console) {
    super(console);
  }

  @Override
  public ExitStatus run() throws IOException {
    AnovaOptions options = prior.in(sphericity.in(choices.options()));
    Provenance provenance = date.provenance();
    CommandFiles files =
        new CommandFiles().reads("", responses).reads("--participants", participants);
    output.check(files);
    outputs.check();
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
    FamilyCorrection correction =
        switch (family) {
          case none -> FamilyCorrection.NONE;
          case holm -> FamilyCorrection.HOLM;
          case fdr -> FamilyCorrection.FDR;
        };
    StudyAnalysis study = StudyAnalysis.of(found.get(), scoring.scoring(), options, correction);
    MissingTables.tell(study, problems);
    outputs.write(study, provenance, files, console());
    output.write(
        switch (format) {
          case text -> StudyReport.text(study, provenance);
          case json -> StudyReport.json(study, provenance);
          case html -> StudyReport.html(study, provenance);
          case tidy -> StudyReport.tidyCsv(study, provenance);
          case wide -> StudyReport.wideCsv(study, provenance);
        },
        console());
    return ExitStatus.of(problems);
  }
}
