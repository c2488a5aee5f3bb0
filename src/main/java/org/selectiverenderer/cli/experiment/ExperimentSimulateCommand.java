package org.selectiverenderer.cli.experiment;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.command.CliCommand;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.command.output.CommandFileCheck;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;
import org.selectiverenderer.command.trust.TrustOption;
import org.selectiverenderer.statistics.anova.AnovaOptions;
import org.selectiverenderer.statistics.data.ResponsesCsvWriter;
import org.selectiverenderer.statistics.detection.DetectionMeasure;
import org.selectiverenderer.statistics.report.PowerReport;
import org.selectiverenderer.statistics.simulation.PowerAnalysis;
import org.selectiverenderer.statistics.simulation.RecognitionListSpec;
import org.selectiverenderer.statistics.simulation.SimulationModel;
import org.selectiverenderer.statistics.simulation.StudySimulator;
import org.selectiverenderer.statistics.simulation.TestedHypothesis;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

@Command(
    name = "simulate",
    description = {
      "Simulates participants of known sensitivity. Prints their answers as a file that experiment"
          + " analyse reads; with --power, how often studies like this find an effect, by simulation"
          + " and by formula, and with --needed, how many participants that takes.",
      "The objects are those of the thesis's Tables 6 to 11, and as many absent ones.",
      "A list of numbers has one number for each condition, or one for all.",
      "With --study it simulates the trials of a study with blocks; with --power too, how often"
          + " such studies find the effects of the analyses that the study plans. Of the other"
          + " options only --effect, --participants, --seed, --output, --trust, and for the power"
          + " --studies, --sphericity and --format count."
    },
    footer = {
      "  ./selective-renderer experiment simulate --participants 54 --d-prime 1.1 \\",
      "      --output r.csv",
      "  ./selective-renderer experiment simulate --participants 54 \\",
      "      --d-prime 0.9,1.2,1.1 --needed",
      "  ./selective-renderer experiment simulate \\",
      "      --study docs/examples/quality-and-light \\",
      "      --effect quality=reduced:ms+80 --output trials.csv",
      "  ./selective-renderer experiment simulate \\",
      "      --study docs/examples/quality-and-light \\",
      "      --effect quality=reduced:ms+40 --power --participants 16"
    })
final class ExperimentSimulateCommand extends CliCommand {
  private enum Format {
    text,
    json
  }

  private enum Dependent {
    dprime(DetectionMeasure.D_PRIME),
    logbeta(DetectionMeasure.LOG_BETA),
    c(DetectionMeasure.CRITERION);

    private final DetectionMeasure measure;

    Dependent(DetectionMeasure measure) {
      this.measure = measure;
    }
  }

  @Option(
      names = "--participants",
      paramLabel = "N",
      description =
          "number of participants, assigned to the conditions in turn (default: 54, or as many as"
              + " the study of --study plans)")
  private @Nullable Integer wanted;

  private int participants = 54;

  @Option(
      names = "--conditions",
      split = ",",
      defaultValue = "high,high-low,selective",
      paramLabel = "NAME",
      description = "names of the conditions (default: ${DEFAULT-VALUE})")
  private List<String> conditions = List.of();

  @Option(
      names = "--d-prime",
      split = ",",
      defaultValue = "1.1",
      paramLabel = "D",
      description = "mean sensitivity d' (default: ${DEFAULT-VALUE})")
  private double[] sensitivities = {};

  @Option(
      names = "--criterion",
      split = ",",
      defaultValue = "0",
      paramLabel = "C",
      description = "mean bias c, above 0 towards no (default: ${DEFAULT-VALUE})")
  private double[] criteria = {};

  @Option(
      names = "--d-prime-sd",
      defaultValue = "0.3",
      paramLabel = "SD",
      description = "standard deviation of d' between participants (default: ${DEFAULT-VALUE})")
  private double sensitivitySpread;

  @Option(
      names = "--criterion-sd",
      defaultValue = "0.25",
      paramLabel = "SD",
      description = "standard deviation of c between participants (default: ${DEFAULT-VALUE})")
  private double criterionSpread;

  @Option(
      names = "--type-d-prime",
      defaultValue = "0",
      paramLabel = "D",
      description = "difference in d' of inconsistent objects (default: ${DEFAULT-VALUE})")
  private double typeSensitivity;

  @Option(
      names = "--type-criterion",
      defaultValue = "0.4",
      paramLabel = "C",
      description =
          "difference in c of inconsistent objects, the bias that the thesis found "
              + "(default: ${DEFAULT-VALUE})")
  private double typeCriterion;

  @Option(
      names = "--seed",
      defaultValue = "1",
      paramLabel = "N",
      description =
          "seed of the simulation; the same seed gives the same answers on any "
              + "number of cores (default: ${DEFAULT-VALUE})")
  private long seed;

  @Option(names = "--power", description = "prints the power of such studies")
  private boolean power;

  @Option(
      names = "--needed",
      description = "also finds the number of participants for the power of --target")
  private boolean needed;

  @Option(
      names = "--goal",
      paramLabel = "condition|type|interaction|equivalence",
      defaultValue = "condition",
      description = "effect that --needed looks for (default: ${DEFAULT-VALUE})")
  private TestedHypothesis goal = TestedHypothesis.condition;

  @Option(
      names = "--target",
      paramLabel = "POWER",
      defaultValue = "0.8",
      description = "power that --needed aims at (default: ${DEFAULT-VALUE})")
  private double target;

  @Option(
      names = "--most",
      defaultValue = "2000",
      paramLabel = "N",
      description =
          "largest number of participants that --needed tries (default: ${DEFAULT-VALUE})")
  private int most;

  @Option(
      names = "--studies",
      defaultValue = "1000",
      paramLabel = "N",
      description =
          "number of studies to simulate for each number of participants (default: "
              + "${DEFAULT-VALUE})")
  private int studies;

  @Option(
      names = "--area",
      paramLabel = "AREA",
      defaultValue = "kitchen",
      description = "area whose answers the power is computed for (default: ${DEFAULT-VALUE})")
  private String area = "";

  @Option(
      names = "--measure",
      paramLabel = "MEASURE",
      defaultValue = "dprime",
      description =
          "measure that the power is computed for: ${COMPLETION-CANDIDATES} (default: "
              + "${DEFAULT-VALUE})")
  private Dependent dependent = Dependent.dprime;

  @Mixin private TrialSimulationOptions trials = new TrialSimulationOptions();
  @Mixin private TrustOption trust = new TrustOption();
  @Mixin private ScoringOptions scoring = new ScoringOptions();
  @Mixin private SphericityOption sphericity = new SphericityOption();
  @Mixin private EquivalenceBoundOptions choices = new EquivalenceBoundOptions();

  @Option(
      names = "--format",
      paramLabel = "FORMAT",
      defaultValue = "text",
      description =
          "format of the power report: ${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE})")
  private @Nullable Format format;

  @Mixin private ReportOutputOption output = new ReportOutputOption();

  ExperimentSimulateCommand(Console console) {
    super(console);
  }

  @Override
  public ExitStatus run() throws IOException {
    if (wanted != null) {
      participants = wanted;
    }
    AnovaOptions options = sphericity.in(choices.options());
    check();
    if (trials.wanted()) {
      return power
          ? trials.power(
              wanted, studies, seed, options, format == Format.json, trust, output, console())
          : trials.write(wanted, seed, trust, output, console());
    }
    SimulationModel model =
        new SimulationModel(
            conditions,
            each("--d-prime", sensitivities),
            each("--criterion", criteria),
            sensitivitySpread,
            criterionSpread,
            typeSensitivity,
            typeCriterion,
            RecognitionListSpec.THESIS);
    if (!model.areas().contains(area)) {
      throw CommandException.usage("--area must be one of " + String.join(", ", model.areas()));
    }
    if (!power && !needed) {
      output.write(
          ResponsesCsvWriter.of(StudySimulator.responses(model, participants, seed)), console());
      return ExitStatus.DONE;
    }
    PowerAnalysis analysis =
        new PowerAnalysis(
            model,
            area,
            dependent.measure,
            scoring.scoring(),
            options,
            studies,
            seed,
            line -> console().message("simulate: " + line));
    checkTested(analysis);
    PowerReport report =
        PowerReport.of(
            analysis,
            participants,
            needed ? Optional.of(new PowerReport.Wanted(goal, target, most)) : Optional.empty());
    output.write(format == Format.json ? report.json() : report.text(), console());
    return ExitStatus.DONE;
  }

  private void check() throws IOException {
    output.check(new CommandFileCheck());
    if (participants < 1 || studies < 1 || most < 1) {
      throw CommandException.usage(
          "--participants, --studies and --most must be whole numbers of at least 1");
    }
    if (!(target > 0 && target < 1)) {
      throw CommandException.usage("--target must be a number between 0 and 1");
    }
    if (!(sensitivitySpread >= 0 && criterionSpread >= 0)
        || !DoubleStream.of(sensitivitySpread, criterionSpread, typeSensitivity, typeCriterion)
            .allMatch(Double::isFinite)) {
      throw CommandException.usage(
          "--d-prime-sd and --criterion-sd must be finite numbers of at least 0");
    }
    if (conditions.stream().distinct().count() < conditions.size()
        || conditions.stream().anyMatch(String::isBlank)) {
      throw CommandException.usage("--conditions must be different names");
    }
  }

  private void checkTested(PowerAnalysis analysis) {
    if (participants <= conditions.size()) {
      throw CommandException.usage(
          "--participants must be more than the number of conditions, %d: with one in each group"
                  .formatted(conditions.size())
              + " there is no error to test against");
    }
    if (needed && !analysis.tested().contains(goal.finding())) {
      List<String> tested =
          Stream.of(TestedHypothesis.values())
              .filter(other -> analysis.tested().contains(other.finding()))
              .map(TestedHypothesis::name)
              .toList();
      throw CommandException.usage(
          tested.isEmpty()
              ? "--needed has nothing to look for: one condition, and objects of one type in the %s"
                  .formatted(area)
              : "--goal %s is not tested by such studies of the %s; choose %s"
                  .formatted(goal, area, String.join(", ", tested)));
    }
  }

  private List<Double> each(String option, double[] values) {
    if (values.length != 1 && values.length != conditions.size()
        || !DoubleStream.of(values).allMatch(Double::isFinite)) {
      throw CommandException.usage(
          option + " must have one number, or one for each of " + String.join(", ", conditions));
    }
    return conditions.stream()
        .map(name -> values[values.length == 1 ? 0 : conditions.indexOf(name)])
        .toList();
  }
}
