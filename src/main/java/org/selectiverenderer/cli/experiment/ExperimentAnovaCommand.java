package org.selectiverenderer.cli.experiment;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.command.CliCommand;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.command.output.CommandFileCheck;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;
import org.selectiverenderer.statistics.anova.Anova;
import org.selectiverenderer.statistics.anova.AnovaOptions;
import org.selectiverenderer.statistics.data.Exclusion;
import org.selectiverenderer.statistics.data.Observations;
import org.selectiverenderer.statistics.data.ObservationsReader;
import org.selectiverenderer.statistics.report.AnovaReport;
import org.selectiverenderer.statistics.report.Provenance;
import org.selectiverenderer.statistics.study.UntestableEffectReporter;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

@Command(
    name = "anova",
    description = {
      "Analyses the variance of a table in long form, with one row for each "
          + "participant and level.",
      "The design is mixed with both --within and --between, repeated measures with "
          + "--within alone, between participants with --between alone. Each of them, and "
          + "--covariate, may be given several times."
    },
    footer = {
      "  ./selective-renderer experiment anova scores.csv --dv d_prime \\",
      "      --subject participant --within object_type --between condition",
      "  ./selective-renderer experiment anova trials.csv --dv ms \\",
      "      --subject participant --within quality --where correct=yes --mean"
    })
final class ExperimentAnovaCommand extends CliCommand {
  /** The largest number of factors; more have too many interactions to interpret. */
  private static final int MOST_FACTORS = 5;

  private enum Format {
    text,
    json,
    html
  }

  @Parameters(paramLabel = "DATA.csv", description = "table in long form (.csv)")
  private Path data = Path.of("");

  @Option(
      names = "--dv",
      required = true,
      paramLabel = "COL",
      description = "column of the dependent variable")
  private String measure = "";

  @Option(
      names = "--subject",
      required = true,
      paramLabel = "COL",
      description = "column of the participants")
  private String subject = "";

  @Option(
      names = "--within",
      paramLabel = "COL",
      description = "column of a factor at whose levels each participant was measured; repeatable")
  private List<String> within = new ArrayList<>();

  @Option(
      names = "--between",
      paramLabel = "COL",
      description = "column of a factor that divides the participants; repeatable")
  private List<String> between = new ArrayList<>();

  @Option(
      names = "--covariate",
      paramLabel = "COL",
      description =
          "column of a number of each participant whose linear effect is taken out of the "
              + "others (analysis of covariance, equal slopes in all groups); repeatable")
  private List<String> covariates = new ArrayList<>();

  @Option(
      names = "--where",
      paramLabel = "COL=CELL",
      description = "analyses only rows with that cell in that column; repeatable")
  private Map<String, String> where = new LinkedHashMap<>();

  @Option(
      names = "--mean",
      description =
          "analyses the mean of a participant's rows at the same levels, as of a table of trials;"
              + " otherwise there must be one row")
  private boolean mean;

  @Option(names = "--correction", paramLabel = "C", description = "the same as --sphericity")
  private SphericityOption.@Nullable Words correction;

  @Mixin private SphericityOption sphericity = new SphericityOption();
  @Mixin private EquivalenceBoundOptions choices = new EquivalenceBoundOptions();
  @Mixin private BayesPriorOptions prior = new BayesPriorOptions();

  @Option(
      names = "--format",
      paramLabel = "FORMAT",
      defaultValue = "text",
      description = "format of the report: ${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE})")
  private Format format = Format.text;

  @Mixin private ReportDateOption date = new ReportDateOption();
  @Mixin private ReportOutputOption output = new ReportOutputOption();

  ExperimentAnovaCommand(Console console) {
    super(console);
  }

  @Override
  public ExitStatus run() throws IOException {
    if (within.isEmpty() && between.isEmpty() && covariates.isEmpty()) {
      throw CommandException.usage("no factor given; name one with --within, --between or both");
    }
    List<String> columns = new ArrayList<>(List.of(measure, subject));
    columns.addAll(within);
    columns.addAll(between);
    columns.addAll(covariates);
    if (columns.stream().map(name -> name.toLowerCase(Locale.ROOT)).distinct().count()
        < columns.size()) {
      throw CommandException.usage(
          "--dv, --subject, --within, --between and --covariate must be different columns");
    }
    if (within.size() + between.size() > MOST_FACTORS) {
      throw CommandException.usage(
          "at most %d factors can be analysed together; leave some out".formatted(MOST_FACTORS));
    }
    AnovaOptions options =
        prior.in(sphericity.in(choices.options(), Optional.ofNullable(correction)));
    Provenance provenance = date.provenance();
    output.check(new CommandFileCheck().reads("", data));
    ProblemCollector problems = new ProblemCollector(console()::problem);
    Optional<Observations> read =
        ObservationsReader.read(
            data,
            new ObservationsReader.Columns(measure, subject, within, between, covariates),
            new ObservationsReader.Rows(where, mean),
            problems);
    if (read.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    Optional<String> obstacle = read.get().design().obstacle();
    if (obstacle.isPresent()) {
      problems.error(
          new SourceLocation(data.toString(), 1, 1), obstacle.get() + "; nothing is analysed");
      return ExitStatus.PROBLEMS;
    }
    Anova anova = Anova.of(read.get().design(), options);
    UntestableEffectReporter.reasons(anova)
        .forEach(
            reason ->
                problems.warning(new SourceLocation(data.toString(), 1, 1), "no F: " + reason));
    List<Exclusion> exclusions = read.get().exclusions();
    output.write(
        switch (format) {
          case text -> AnovaReport.text(anova, exclusions, read.get().source(), provenance);
          case json -> AnovaReport.json(anova, exclusions, read.get().source(), provenance);
          case html -> AnovaReport.html(anova, exclusions, read.get().source(), provenance);
        },
        console());
    return ExitStatus.of(problems);
  }
}
