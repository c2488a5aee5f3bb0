package org.selectiverenderer.statistics.study;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.statistics.anova.AnovaOptions;
import org.selectiverenderer.statistics.data.ResponsesCsvWriter;
import org.selectiverenderer.statistics.data.ResponsesReader;
import org.selectiverenderer.statistics.detection.ConfidenceThreshold;
import org.selectiverenderer.statistics.detection.DetectionScorer;
import org.selectiverenderer.statistics.simulation.RecognitionListSpec;
import org.selectiverenderer.statistics.simulation.SimulationModel;
import org.selectiverenderer.statistics.simulation.StudySimulator;

class MultipleTestingCorrectionTest {
  private static final List<Double> P = List.of(0.01, 0.04, 0.03, 0.005, 0.2, 0.04);

  /** R: p.adjust(c(.01, .04, .03, .005, .2, .04), "holm"). */
  @Test
  void holmAsInR() {
    assertThat(MultipleTestingCorrection.HOLM.of(P))
        .containsExactly(new double[] {0.05, 0.12, 0.12, 0.03, 0.2, 0.12}, within(1e-12));
  }

  /** R: p.adjust(c(.01, .04, .03, .005, .2, .04), "BH"). */
  @Test
  void benjaminiAndHochbergAsInR() {
    assertThat(MultipleTestingCorrection.FDR.of(P))
        .containsExactly(new double[] {0.03, 0.048, 0.048, 0.03, 0.2, 0.048}, within(1e-12));
    assertThat(MultipleTestingCorrection.FDR.of(List.of())).isEmpty();
  }

  @Test
  void noneLeavesThemAsTheyAre() {
    assertThat(MultipleTestingCorrection.NONE.of(P)).startsWith(0.01, 0.04);
  }

  /** Two areas, three measures; the kitchen has three effects, the office one. */
  @Test
  void aFamilyIsAllEffectsOfALevel() {
    StudyAnalysis study = study(MultipleTestingCorrection.HOLM);
    List<FamilywiseTest> all =
        study.tests().stream()
            .filter(test -> test.analysis().level() == ConfidenceThreshold.ALL)
            .toList();
    assertThat(all).hasSize(3 * 3 + 3).allMatch(test -> test.size() == 12);
    double least = all.stream().mapToDouble(FamilywiseTest::p).min().orElseThrow();
    FamilywiseTest first = all.stream().filter(test -> test.p() == least).findFirst().orElseThrow();
    assertThat(study.adjusted(first.analysis(), first.effect())).isEqualTo(Math.min(1, 12 * least));
  }

  @Test
  void ratingsArePooledByConditionAndKeptByParticipant() {
    StudyAnalysis study = study(MultipleTestingCorrection.NONE);
    List<RatingAnalysis> pooled = study.ratings("kitchen", true);
    assertThat(pooled)
        .extracting(RatingAnalysis::type)
        .containsExactly("consistent", "consistent", "inconsistent", "inconsistent");
    assertThat(pooled).allMatch(score -> score.participants() == 6);
    List<RatingAnalysis> own = study.ratings("kitchen", false);
    assertThat(own).hasSize(24).allMatch(score -> score.participants() == 1);
    for (RatingAnalysis score : pooled) {
      int[] sums =
          IntStream.range(0, 10)
              .map(
                  i ->
                      own.stream()
                          .filter(one -> one.type().equals(score.type()))
                          .filter(one -> one.condition().equals(score.condition()))
                          .mapToInt(one -> one.ratings().signal().get(i))
                          .sum())
              .toArray();
      assertThat(score.ratings().signal())
          .containsExactlyElementsOf(IntStream.of(sums).boxed().toList());
    }
    assertThat(study.unrated()).isZero();
  }

  private static StudyAnalysis study(MultipleTestingCorrection family) {
    SimulationModel model =
        new SimulationModel(
            List.of("high", "selective"),
            List.of(1.0, 1.5),
            List.of(0.1, 0.1),
            0.3,
            0.2,
            -0.2,
            0.3,
            List.of(
                new RecognitionListSpec("kitchen", "consistent", 12),
                new RecognitionListSpec("kitchen", "inconsistent", 8),
                new RecognitionListSpec("office", "neutral", 10)));
    String answers = ResponsesCsvWriter.of(StudySimulator.responses(model, 12, 5));
    return StudyAnalysis.of(
        ResponsesReader.parse("r.csv", answers, Optional.empty(), new ProblemCollector())
            .orElseThrow(),
        DetectionScorer.DEFAULT,
        AnovaOptions.DEFAULT,
        family);
  }
}
