package org.selectiverenderer.statistics.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ForkJoinPool;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.statistics.anova.AnovaOptions;
import org.selectiverenderer.statistics.data.Responses;
import org.selectiverenderer.statistics.data.ResponsesCsvWriter;
import org.selectiverenderer.statistics.data.ResponsesReader;
import org.selectiverenderer.statistics.detection.ConfidenceThreshold;
import org.selectiverenderer.statistics.detection.DetectionIndices;
import org.selectiverenderer.statistics.detection.DetectionMeasure;
import org.selectiverenderer.statistics.detection.DetectionScorer;
import org.selectiverenderer.statistics.detection.ExtremeRateCorrection;
import org.selectiverenderer.statistics.detection.LowConfidencePolicy;
import org.selectiverenderer.statistics.detection.Response;
import org.selectiverenderer.statistics.detection.ResponseCounts;
import org.selectiverenderer.statistics.study.AreaAnalyser;

class SimulationTest {
  private static final SimulationModel ALIKE = model(List.of(1.1, 1.1, 1.1));

  @Test
  void theSensitivityAndCriterionPutInComeOut() {
    SimulationModel model =
        new SimulationModel(
            List.of("high"),
            List.of(1.4),
            List.of(0.3),
            0,
            0,
            0,
            0,
            List.of(new RecognitionListSpec("kitchen", "consistent", 10)));
    List<Response> answers = StudySimulator.responses(model, 2000, 7);
    DetectionIndices found =
        DetectionIndices.of(
            ResponseCounts.of(answers, ConfidenceThreshold.ALL, LowConfidencePolicy.DISCARD),
            ExtremeRateCorrection.LOG_LINEAR);
    assertThat(found.dPrime()).isEqualTo(1.4, within(0.03));
    assertThat(found.criterion()).isEqualTo(0.3, within(0.02));
  }

  @Test
  void simulatedAnswersSurviveTheirFile() {
    List<Response> answers = StudySimulator.responses(ALIKE, 9, 3);
    ProblemCollector problems = new ProblemCollector();
    Responses read =
        ResponsesReader.parse("r.csv", ResponsesCsvWriter.of(answers), Optional.empty(), problems)
            .orElseThrow();
    assertThat(problems.list()).isEmpty();
    assertThat(read.usable()).hasSameSizeAs(answers);
    assertThat(
            new DetectionScorer(ExtremeRateCorrection.LOG_LINEAR, LowConfidencePolicy.DISCARD)
                .scores(read.usable()))
        .isEqualTo(
            new DetectionScorer(ExtremeRateCorrection.LOG_LINEAR, LowConfidencePolicy.DISCARD)
                .scores(answers));
  }

  @Test
  void aLargerStudyBeginsWithTheParticipantsOfASmallerOne() {
    List<Response> small = StudySimulator.responses(ALIKE, 5, 3);
    assertThat(StudySimulator.responses(ALIKE, 8, 3)).startsWith(small.toArray(new Response[0]));
    assertThat(StudySimulator.responses(ALIKE, 5, 4)).isNotEqualTo(small);
  }

  @Test
  void powerIsTheSameOnOneCoreAndOnFour() throws ExecutionException, InterruptedException {
    PowerAnalysis analysis = analysis(ALIKE, 60);
    List<PowerEstimate> found = new ArrayList<>();
    for (int cores : new int[] {1, 4}) {
      ForkJoinPool pool = new ForkJoinPool(cores);
      try {
        found.add(pool.submit(() -> analysis.power(12)).get());
      } finally {
        pool.shutdown();
      }
    }
    assertThat(found.get(0)).isEqualTo(found.get(1));
  }

  /** The whole way from answers to p holds its level of error: 0.05, with SE 0.009. */
  @Test
  void withoutADifferenceOneStudyInTwentyFindsOne() {
    PowerEstimate power = analysis(ALIKE, 600).power(54);
    assertThat(power.share(AreaAnalyser.BETWEEN)).isEqualTo(0.05, within(0.025));
    assertThat(power.share(AreaAnalyser.WITHIN + " x " + AreaAnalyser.BETWEEN))
        .isEqualTo(0.05, within(0.025));
  }

  @Test
  void moreParticipantsFindALargeDifference() {
    PowerAnalysis analysis = analysis(model(List.of(0.4, 1.2, 2.0)), 100);
    PowerAnalysis.Needed found = analysis.needed(AreaAnalyser.BETWEEN, 0.8, 200).orElseThrow();
    int needed = found.participants();
    assertThat(needed % 3).isZero();
    assertThat(analysis.power(needed).share(AreaAnalyser.BETWEEN)).isGreaterThanOrEqualTo(0.8);
    assertThat(analysis.power(needed - 3).share(AreaAnalyser.BETWEEN)).isLessThan(0.8);
    assertThat(analysis(ALIKE, 40).needed(AreaAnalyser.BETWEEN, 0.8, 24)).isEmpty();
  }

  @Test
  void theNumberNeededHasAnInterval() {
    PowerAnalysis analysis = analysis(model(List.of(0.6, 1.2, 1.6)), 40);
    PowerAnalysis.Needed found = analysis.needed(AreaAnalyser.BETWEEN, 0.8, 200).orElseThrow();
    assertThat(found.low()).isLessThan(found.participants());
    assertThat(found.high().orElseThrow()).isGreaterThan(found.participants());
    PowerEstimate low = analysis.power(found.low());
    assertThat(low.finding(AreaAnalyser.BETWEEN).high()).isGreaterThanOrEqualTo(0.8);
    PowerEstimate high = analysis.power(found.high().orElseThrow());
    assertThat(high.finding(AreaAnalyser.BETWEEN).low()).isGreaterThanOrEqualTo(0.8);
    assertThat(
            analysis.needed(AreaAnalyser.BETWEEN, 0.8, found.participants()).orElseThrow().high())
        .isEmpty();
  }

  @Test
  void whatIsNotTestedIsNotSearchedFor() {
    PowerAnalysis office =
        new PowerAnalysis(
            ALIKE,
            "office",
            DetectionMeasure.D_PRIME,
            DetectionScorer.DEFAULT,
            AnovaOptions.DEFAULT,
            5,
            1,
            l -> {});
    assertThat(office.tested()).containsExactly(AreaAnalyser.BETWEEN, PowerAnalysis.EQUIVALENCE);
    assertThatThrownBy(() -> office.needed(AreaAnalyser.WITHIN, 0.8, 2000))
        .isInstanceOf(IllegalArgumentException.class);
    PowerEstimate power = office.power(9);
    assertThatThrownBy(() -> power.share(AreaAnalyser.WITHIN))
        .isInstanceOf(IllegalArgumentException.class);
  }

  /** The lists have as many absent as present objects; O of Tables 6 to 11 counts the present. */
  @Test
  void asManyAbsentObjectsAreAskedForAsPresentOnes() {
    List<Response> answers = StudySimulator.responses(ALIKE, 1, 1);
    assertThat(answers).hasSize(2 * (12 + 6 + 20 + 5 + 4 + 7 + 17 + 4 + 4));
    assertThat(answers.stream().filter(Response::present)).hasSize(79);
    assertThat(answers.stream().filter(answer -> answer.area().equals("kitchen"))).hasSize(36);
  }

  private static PowerAnalysis analysis(SimulationModel model, int studies) {
    return new PowerAnalysis(
        model,
        "kitchen",
        DetectionMeasure.D_PRIME,
        DetectionScorer.DEFAULT,
        AnovaOptions.DEFAULT,
        studies,
        11,
        line -> {});
  }

  private static SimulationModel model(List<Double> sensitivities) {
    return new SimulationModel(
        List.of("high", "high-low", "selective"),
        sensitivities,
        List.of(0.0, 0.0, 0.0),
        0.3,
        0.25,
        0,
        0.4,
        RecognitionListSpec.THESIS);
  }
}
