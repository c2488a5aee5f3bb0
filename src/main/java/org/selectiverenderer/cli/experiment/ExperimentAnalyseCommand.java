package org.selectiverenderer.cli.experiment;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.command.CliCommand;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.command.output.CommandFileCheck;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;
import org.selectiverenderer.statistics.anova.AnovaOptions;
import org.selectiverenderer.statistics.data.ParticipantRoster;
import org.selectiverenderer.statistics.data.Responses;
import org.selectiverenderer.statistics.data.ResponsesReader;
import org.selectiverenderer.statistics.report.Provenance;
import org.selectiverenderer.statistics.report.StudyReport;
import org.selectiverenderer.statistics.study.MultipleTestingCorrection;
import org.selectiverenderer.statistics.study.StudyAnalysis;
import org.selectiverenderer.statistics.study.UntestableEffectReporter;
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
          + "confidence.",
      "Of a study with blocks of trials, STUDY.json, it makes the analyses that the study plans by"
          + " its key \"analysis\", or else all measures by all factors, as exploratory."
    },
    footer = {
      "  ./selective-renderer experiment analyse r.csv --format html --output r.html",
      "  ./selective-renderer experiment analyse docs/examples/quality-and-light \\",
      "      --data trials.csv"
    })
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

  @Parameters(
      paramLabel = "RESPONSES.csv|STUDY.json",
      description = "table of the answers (.csv), or a study with blocks of trials, or its folder")
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

  @Mixin private StudyAnalysisOptions trials = new StudyAnalysisOptions();
  @Mixin private ScoringOptions scoring = new ScoringOptions();
  @Mixin private SphericityOption sphericity = new SphericityOption();
  @Mixin private EquivalenceBoundOptions choices = new EquivalenceBoundOptions();
  @Mixin private BayesPriorOptions prior = new BayesPriorOptions();

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

  @Mixin private ReportDateOption date = new ReportDateOption();
  @Mixin private StudyOutputOptions outputs = new StudyOutputOptions();
  @Mixin private ReportOutputOption output = new ReportOutputOption();

  ExperimentAnalyseCommand(Console console) {
    super(console);
  }

  @Override
  public ExitStatus run() throws IOException {
    AnovaOptions options = prior.in(sphericity.in(choices.options()));
    Provenance provenance = date.provenance();
    if (StudyAnalysisOptions.isStudy(responses)) {
      return study(options, provenance);
    }
    trials.checkUnused();
    CommandFileCheck files =
        new CommandFileCheck().reads("", responses).reads("--participants", participants);
    output.check(files);
    outputs.check();
    ProblemCollector problems = new ProblemCollector(console()::problem);
    Optional<ParticipantRoster> roster = Optional.empty();
    if (participants != null) {
      roster = ParticipantRoster.read(participants, problems);
      if (roster.isEmpty()) {
        return ExitStatus.PROBLEMS;
      }
    }
    Optional<Responses> found = ResponsesReader.read(responses, roster, counterbalanced, problems);
    if (found.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    MultipleTestingCorrection correction =
        switch (family) {
          case none -> MultipleTestingCorrection.NONE;
          case holm -> MultipleTestingCorrection.HOLM;
          case fdr -> MultipleTestingCorrection.FDR;
        };
    StudyAnalysis study = StudyAnalysis.of(found.get(), scoring.scoring(), options, correction);
    UntestableEffectReporter.tell(study, problems);
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

  private ExitStatus study(AnovaOptions options, Provenance provenance) throws IOException {
    if (participants != null
        || counterbalanced
        || family != Family.none
        || outputs.wanted()
        || format == Format.tidy
        || format == Format.wide) {
      throw CommandException.usage(
          "--participants, --counterbalanced, --family, --tables, --figures, --r and the formats tidy"
              + " and wide are for answers about remembered objects, not for a study");
    }
    CommandFileCheck files = new CommandFileCheck();
    trials.check(files);
    output.check(files);
    ProblemCollector problems = new ProblemCollector(console()::problem);
    Optional<StudyAnalysisOptions.Result> result =
        trials.result(responses, options, console(), problems);
    if (result.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    output.write(
        switch (format) {
          case json -> result.get().report().json(result.get().source(), provenance);
          case html -> result.get().report().html(result.get().source(), provenance);
          default -> result.get().report().text(result.get().source(), provenance);
        },
        console());
    return ExitStatus.of(problems);
  }
}
