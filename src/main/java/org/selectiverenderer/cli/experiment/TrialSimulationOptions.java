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

  /** Writes the trials of participants, by default of as many as the study plans. */
  ExitStatus write(
      @Nullable Integer participants,
      long seed,
      TrustOption trust,
      ReportOutputOption output,
      Console console)
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
    ProblemCollector problems = new ProblemCollector(console::problem);
    Optional<LoadedStudy> material =
        new StudyArgument(study == null ? Path.of("") : study).read(trust, console, problems);
    if (material.isEmpty()) {
      return ExitStatus.PROBLEMS;
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
    try {
      output.write(
          simulator.csv(
              participants == null ? material.get().study().participants() : participants),
          console);
    } catch (IllegalArgumentException e) {
      throw CommandException.usage(String.valueOf(e.getMessage()));
    }
    return ExitStatus.of(problems);
  }
}
