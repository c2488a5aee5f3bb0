package org.selectiverenderer.statistics.script;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.statistics.anova.AnovaOptions;
import org.selectiverenderer.statistics.anova.Effect;
import org.selectiverenderer.statistics.data.ResponsesCsvWriter;
import org.selectiverenderer.statistics.data.ResponsesReader;
import org.selectiverenderer.statistics.detection.ConfidenceThreshold;
import org.selectiverenderer.statistics.detection.DetectionMeasure;
import org.selectiverenderer.statistics.detection.DetectionScorer;
import org.selectiverenderer.statistics.detection.ExtremeRateCorrection;
import org.selectiverenderer.statistics.detection.LowConfidencePolicy;
import org.selectiverenderer.statistics.simulation.RecognitionListSpec;
import org.selectiverenderer.statistics.simulation.SimulationModel;
import org.selectiverenderer.statistics.simulation.StudySimulator;
import org.selectiverenderer.statistics.study.AreaAnalyser;
import org.selectiverenderer.statistics.study.AreaAnalysis;
import org.selectiverenderer.testing.RequiresProgram;

class RScriptGeneratorTest {
  @TempDir Path folder;

  @Test
  void theScriptNamesItsFileAndItsChoices() {
    String script =
        RScriptGenerator.analysis(
            "my \"best\"\\é.csv",
            new DetectionScorer(ExtremeRateCorrection.HALF_TRIAL, LowConfidencePolicy.AS_NO));
    assertThat(script)
        .contains(
            "responses <- \"my \\\"best\\\"\\\\\\U{e9}.csv\"",
            "correction <- \"half\"",
            "guesses <- \"no\"")
        .doesNotContain("@RESPONSES@", "@CORRECTION@", "@GUESSES@");
  }

  /**
   * The example of docs/statistics.md: R has the same F, and of single answers the difference
   * between types of objects is gone.
   */
  @Test
  @RequiresProgram("Rscript")
  void rRepeatsTheAnalysesAndTheMixedProbitFindsNoEffectOfTypeOnSensitivity()
      throws IOException, InterruptedException {
    requireLme4();
    String answers =
        ResponsesCsvWriter.of(
            StudySimulator.responses(
                new SimulationModel(
                    List.of("high", "high-low", "selective"),
                    List.of(1.1, 1.1, 1.1),
                    List.of(0.0, 0.0, 0.0),
                    0.3,
                    0.25,
                    0,
                    0.4,
                    RecognitionListSpec.THESIS),
                54,
                2009));
    String text = run(answers, DetectionScorer.DEFAULT, "kitchen");
    AreaAnalyser kitchen =
        AreaAnalyser.of(
            ResponsesReader.parse("r.csv", answers, Optional.empty(), new ProblemCollector())
                .orElseThrow(),
            DetectionScorer.DEFAULT,
            "kitchen");
    for (ConfidenceThreshold level : ConfidenceThreshold.values()) {
      for (DetectionMeasure measure : DetectionMeasure.values()) {
        AreaAnalysis ours = kitchen.analysis(level, measure, AnovaOptions.DEFAULT);
        for (Effect effect : ours.anova().orElseThrow().effects()) {
          assertThat(text)
              .containsPattern(
                  String.format(
                      Locale.ROOT,
                      "\\b%.0f +%.0f +%.3f\\b",
                      effect.df1(),
                      effect.df2(),
                      effect.f()));
        }
      }
    }
    // lme4 1.1-31: log likelihood -1104.020, old_c:type chisq = 1.999, p = .157; from its own start
    // glmer ends at -1111.404, without a variance of the criterion. Last digits may differ.
    assertThat(text).containsPattern("log likelihood = -1104\\.0\\d\\d");
    assertThat(text).containsPattern("old_c:type +1 +(1\\.9|2\\.0)\\d\\d +0\\.1[56]\\d");
    assertThat(text).containsPattern("type +0\\.010 +0\\.1[56]\\d");
    assertThat(text).doesNotContain("other area", "== office ==");
  }

  @Test
  @RequiresProgram("Rscript")
  void whatIsWrongIsOneLine() throws IOException, InterruptedException {
    assertThat(run("participant,area\nx,y\n", DetectionScorer.DEFAULT))
        .contains("usable.csv lacks condition, object, consistency");
  }

  /** R may be there without it; a build that must have R must have it too. */
  private static void requireLme4() throws IOException, InterruptedException {
    boolean there =
        new ProcessBuilder("Rscript", "-e", "quit(status = !requireNamespace('lme4'))")
                .redirectErrorStream(true)
                .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                .start()
                .waitFor()
            == 0;
    assumeTrue(
        there || "1".equals(System.getenv("SELECTIVE_RENDERER_REQUIRE_R")),
        "R has no package lme4 (Debian: r-cran-lme4)");
  }

  private String run(String answers, DetectionScorer scoring, String... areas)
      throws IOException, InterruptedException {
    Files.writeString(folder.resolve("usable.csv"), answers);
    Path script = folder.resolve(RScriptGenerator.NAME);
    Files.writeString(script, RScriptGenerator.analysis("usable.csv", scoring));
    List<String> command = new ArrayList<>(List.of("Rscript", script.toString()));
    command.addAll(List.of(areas));
    Path out = folder.resolve("out.txt");
    new ProcessBuilder(command)
        .redirectErrorStream(true)
        .redirectOutput(out.toFile())
        .start()
        .waitFor();
    return Files.readString(out);
  }
}
