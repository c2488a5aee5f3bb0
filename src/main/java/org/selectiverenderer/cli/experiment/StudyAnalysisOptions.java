package org.selectiverenderer.cli.experiment;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.command.output.CommandFileCheck;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.OutputFile;
import org.selectiverenderer.command.trust.TrustOption;
import org.selectiverenderer.formats.csv.CsvTable;
import org.selectiverenderer.statistics.anova.AnovaOptions;
import org.selectiverenderer.statistics.data.DataSource;
import org.selectiverenderer.statistics.report.DesignReport;
import org.selectiverenderer.statistics.report.DesignReport.Cells;
import org.selectiverenderer.statistics.script.DesignScript;
import org.selectiverenderer.study.analysis.StudyReportOfTrials;
import org.selectiverenderer.study.analysis.StudyTrials;
import org.selectiverenderer.study.analysis.TrialAnalyses;
import org.selectiverenderer.study.analysis.TrialAnalyses.Analysis;
import org.selectiverenderer.study.definition.StudyTemplate;
import org.selectiverenderer.study.design.PlannedAnalysis.Test;
import org.selectiverenderer.study.session.CollectedAnswers;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.session.PaperAnswers;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** The options for analysing the trials of a study by its own design. */
final class StudyAnalysisOptions {
  /** More time needs no analysis of a study. */
  private static final Duration LIMIT = Duration.ofMinutes(10);

  @Option(
      names = "--data",
      paramLabel = "TRIALS.csv",
      description =
          "of a study: table of its trials, as experiment collect --trials and experiment simulate"
              + " --study write it (default: those of its sessions)")
  private @Nullable Path data;

  @Option(
      names = "--exploratory",
      description =
          "of a study: adds what it does not plan, all measures of each block by all its factors;"
              + " done in any case where it plans nothing")
  private boolean exploratory;

  @Option(
      names = "--r-script",
      paramLabel = "F.R",
      description =
          "of a study: also writes a script for R that repeats the analyses with afex, and mixed"
              + " models with lme4 and lmerTest, with its data in F-data.csv")
  private @Nullable Path script;

  @Option(
      names = "--run-r",
      description =
          "of a study: runs that script by Rscript and adds its results to the report; at most ten"
              + " minutes")
  private boolean runs;

  @Mixin private TrustOption trust = new TrustOption();

  /** A study's report with the data that it is of. */
  record Result(DesignReport report, DataSource source) {}

  /** Returns whether the argument of the command is a study and not a table. */
  static boolean isStudy(Path file) {
    return Files.isRegularFile(file.resolve(StudyTemplate.STUDY))
        || file.toString().endsWith(".json");
  }

  /** Complains of options that only a study has. */
  void checkUnused() {
    if (data != null || exploratory || script != null || runs) {
      throw CommandException.usage(
          "--data, --exploratory, --r-script and --run-r need a study, STUDY.json");
    }
  }

  void check(CommandFileCheck files) throws IOException {
    files.reads("--data", data);
    if (script != null) {
      OutputFile.check("--r-script", script, ".r");
      files.writes("--r-script", script).writes("--r-script", table(script));
    }
  }

  /** Returns the table that the script reads, beside it. */
  private static Path table(Path script) {
    return script.resolveSibling(
        script.getFileName().toString().replaceFirst("\\.[Rr]$", "") + "-data.csv");
  }

  /**
   * Analyses a study.
   *
   * @return empty if it or its data have errors, which are reported to {@code problems}
   */
  Optional<Result> result(
      Path file, AnovaOptions options, Console console, ProblemCollector problems)
      throws IOException {
    Optional<LoadedStudy> study = new StudyArgument(file).read(trust, console, problems);
    if (study.isEmpty()) {
      return Optional.empty();
    }
    if (study.get().study().design().blocks().isEmpty()) {
      throw CommandException.usage(
          "the study has no \"blocks\" of trials; collect its answers with experiment collect"
              + " --responses, and analyse that file");
    }
    Optional<StudyTrials> trials = trials(study.get(), problems);
    if (trials.isEmpty()) {
      return Optional.empty();
    }
    SourceLocation place = SourceLocation.of(trials.get().table().file());
    if (trials.get().rows().isEmpty()) {
      problems.error(place, "there are no trials to analyse");
      return Optional.empty();
    }
    TrialAnalyses all = new TrialAnalyses(study.get(), trials.get());
    List<Analysis> analyses = new ArrayList<>(all.planned());
    if (exploratory || analyses.isEmpty()) {
      analyses.addAll(all.exploratory());
    }
    for (Analysis analysis : analyses) {
      analysis
          .data()
          .obstacle()
          .ifPresent(
              reason ->
                  problems.warning(
                      place, "%s is not tested: %s".formatted(analysis.plan().name(), reason)));
    }
    DesignScript repeated = TrialAnalyses.script(analyses);
    if (script != null) {
      OutputFile.writePrivate(table(script), repeated.data());
      OutputFile.writePrivate(script, repeated.script(table(script).getFileName().toString()));
    } else if (!runs) {
      analyses.stream()
          .filter(analysis -> analysis.plan().test() == Test.MIXED_MODEL)
          .forEach(
              analysis ->
                  problems.warning(
                      analysis.plan().place(),
                      "the mixed model of %s is fitted by R alone; add --run-r or --r-script"
                          .formatted(analysis.plan().name())));
    }
    List<List<Cells>> tables = new ArrayList<>();
    if (runs) {
      new RScriptRun("Rscript", LIMIT)
          .tables(repeated, problems)
          .ifPresent(found -> found.forEach(table -> tables.add(List.of(table))));
    }
    List<String> changed =
        data == null ? StudyReportOfTrials.withAnotherPlan(study.get()) : List.of();
    return Optional.of(
        new Result(
            new StudyReportOfTrials(study.get(), options, changed).of(analyses, tables),
            trials.get().source()));
  }

  private Optional<StudyTrials> trials(LoadedStudy study, ProblemCollector problems)
      throws IOException {
    if (data != null) {
      byte[] content = CsvTable.bytes(data);
      return StudyTrials.read(
          data.toString(),
          content,
          DataSource.of(data.getFileName().toString(), content),
          study.study().design(),
          problems);
    }
    byte[] content =
        CollectedAnswers.of(
                study, OptionalInt.empty(), PaperAnswers.read(study, List.of(), problems), problems)
            .trials()
            .getBytes(StandardCharsets.UTF_8);
    String name = "trials of " + study.study().file().getFileName();
    return StudyTrials.read(
        name, content, DataSource.of(name, content), study.study().design(), problems);
  }
}
