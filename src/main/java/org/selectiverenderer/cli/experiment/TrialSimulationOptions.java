package org.selectiverenderer.cli.experiment;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;
import org.selectiverenderer.command.trust.TrustOption;
import org.selectiverenderer.statistics.anova.AnovaOptions;
import org.selectiverenderer.statistics.report.PlannedPowerReport;
import org.selectiverenderer.study.analysis.PlannedPower;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.session.SimulatedEffect;
import org.selectiverenderer.study.session.TrialSimulator;
import picocli.CommandLine.Option;

/** The options for simulating the trials of a study. */
final class TrialSimulationOptions {
  @Option(
      names = "--study",
      paramLabel = "STUDY.json",
      description =
          "study with blocks of trials, or its folder; prints a table of simulated trials as"
              + " experiment collect --trials writes it")
  private @Nullable Path study;

  @Option(
      names = "--effect",
      paramLabel = "FACTOR=LEVEL:MEASURE+N",
      description =
          "adds a number to a measure at a level, or at several with commas between them: to ms"
              + " milliseconds, to correct a share of correct responses, to the id of a scale"
              + " steps; repeatable")
  private List<String> effects = new ArrayList<>();

  /** Returns whether trials of a study are wanted. */
  boolean wanted() {
    if (study == null && !effects.isEmpty()) {
      throw CommandException.usage("--effect needs --study");
    }
    return study != null;
  }

  private record Wanted(LoadedStudy study, List<SimulatedEffect> effects, int participants) {}

  /** Writes the trials of participants, by default of as many as the study plans. */
  ExitStatus write(
      @Nullable Integer participants,
      long seed,
      TrustOption trust,
      ReportOutputOption output,
      Console console)
      throws IOException {
    ProblemCollector problems = new ProblemCollector(console::problem);
    Optional<Wanted> wanted = read(participants, seed, trust, console, problems);
    if (wanted.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    try {
      output.write(
          new TrialSimulator(wanted.get().study(), wanted.get().effects(), seed)
              .csv(wanted.get().participants()),
          console);
    } catch (IllegalArgumentException e) {
      throw CommandException.usage(String.valueOf(e.getMessage()));
    }
    return ExitStatus.of(problems);
  }

  /**
   * Writes the power of the analyses that the study plans.
   *
   * @param studies number of studies to simulate
   * @param json whether the report is JSON
   */
  ExitStatus power(
      @Nullable Integer participants,
      int studies,
      long seed,
      AnovaOptions options,
      boolean json,
      TrustOption trust,
      ReportOutputOption output,
      Console console)
      throws IOException {
    ProblemCollector problems = new ProblemCollector(console::problem);
    Optional<Wanted> wanted = read(participants, seed, trust, console, problems);
    if (wanted.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    LoadedStudy material = wanted.get().study();
    if (material.study().design().analyses().isEmpty()) {
      throw CommandException.usage(
          "--power needs a study that plans its analyses (key \"analysis\")");
    }
    PlannedPower power;
    try {
      power =
          PlannedPower.of(
              material,
              wanted.get().effects(),
              options,
              wanted.get().participants(),
              studies,
              seed,
              line -> console.message("simulate: " + line));
    } catch (IllegalArgumentException e) {
      throw CommandException.usage(String.valueOf(e.getMessage()));
    }
    PlannedPowerReport report =
        new PlannedPowerReport(
            material.study().name(),
            power.participants(),
            power.studies(),
            seed,
            effects,
            power.effects().stream()
                .map(
                    each ->
                        new PlannedPowerReport.Row(
                            each.analysis(), each.finding(), each.untested()))
                .toList());
    output.write(json ? report.json() : report.text(), console);
    return ExitStatus.of(problems);
  }

  /** Reads the study and checks that each effect can do something in it. */
  private Optional<Wanted> read(
      @Nullable Integer participants,
      long seed,
      TrustOption trust,
      Console console,
      ProblemCollector problems)
      throws IOException {
    List<SimulatedEffect> parsed =
        effects.stream()
            .map(
                text ->
                    SimulatedEffect.of(text)
                        .orElseThrow(
                            () ->
                                CommandException.usage(
                                    "--effect must be such as quality=reduced:ms+80, not '%s'"
                                        .formatted(text))))
            .toList();
    Optional<LoadedStudy> material =
        new StudyArgument(study == null ? Path.of("") : study).read(trust, console, problems);
    if (material.isEmpty()) {
      return Optional.empty();
    }
    if (material.get().study().design().blocks().isEmpty()) {
      throw CommandException.usage("--study must name a study with \"blocks\" of trials");
    }
    TrialSimulator simulator = new TrialSimulator(material.get(), parsed, seed);
    for (int i = 0; i < parsed.size(); i++) {
      Optional<String> fault = simulator.fault(parsed.get(i));
      if (fault.isPresent()) {
        throw CommandException.usage("--effect %s: %s".formatted(effects.get(i), fault.get()));
      }
    }
    return Optional.of(
        new Wanted(
            material.get(),
            parsed,
            participants == null ? material.get().study().participants() : participants));
  }
}
