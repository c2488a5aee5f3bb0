package org.selectiverenderer.study.design;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.study.design.TrialBlock.Order;
import org.selectiverenderer.study.design.TrialBlock.Pairing;
import org.selectiverenderer.study.design.TrialBlock.PracticeCriterion;
import org.selectiverenderer.study.design.TrialBlock.TrialStaircase;

class BlockProgressTest {
  private static final StudyGroup ALL = StudyGroup.of(List.of()).get(0);

  private static Factor factor(String name, List<String> levels) {
    return new Factor(
        name,
        Factor.Scope.WITHIN,
        levels.stream().map(level -> new Factor.Level(level, TrialSettings.NONE)).toList());
  }

  private static TrialBlock block(
      List<Factor> factors,
      int rest,
      Optional<PracticeCriterion> practice,
      Optional<TrialStaircase> staircase) {
    return new TrialBlock(
        "main",
        factors,
        Optional.empty(),
        Pairing.CROSSED,
        2,
        Order.RANDOM,
        Map.of(),
        TrialSettings.NONE,
        List.of(),
        rest,
        practice,
        staircase);
  }

  private static BlockProgress progress(TrialBlock block) {
    return new BlockProgress(block, ALL, 0, 11, Map.of());
  }

  private static TrialResult result(Trial trial, Optional<Boolean> correct) {
    return TrialResult.of(trial, "f", OptionalDouble.of(500), correct);
  }

  @Test
  void eachTrialComesOnceAndParticipantsRestInBetween() {
    BlockProgress progress =
        progress(
            block(
                List.of(factor("quality", List.of("a", "b", "c"))),
                4,
                Optional.empty(),
                Optional.empty()));
    List<Trial> seen = new ArrayList<>();
    List<Integer> rests = new ArrayList<>();
    while (progress.next().isPresent()) {
      if (progress.restIsDue()) {
        rests.add(progress.done());
      }
      Trial next = progress.next().orElseThrow();
      seen.add(next);
      progress.add(result(next, Optional.empty()));
    }
    assertThat(seen).hasSize(6).isEqualTo(progress.order());
    assertThat(rests).containsExactly(4);
  }

  @Test
  void practiceGoesOnUntilItsCriterionIsMet() {
    TrialBlock block =
        block(
            List.of(factor("quality", List.of("a", "b"))),
            0,
            Optional.of(new PracticeCriterion(0.75, 3)),
            Optional.empty());
    BlockProgress progress = progress(block);
    for (int trial = 0; trial < 4; trial++) {
      progress.add(result(progress.next().orElseThrow(), Optional.of(trial < 2)));
    }
    assertThat(progress.next().orElseThrow().id()).isEqualTo("main-round2-001");
    for (int trial = 0; trial < 4; trial++) {
      progress.add(result(progress.next().orElseThrow(), Optional.of(trial < 3)));
    }
    assertThat(progress.next()).isEmpty();
    assertThat(progress.failed()).isFalse();
  }

  @Test
  void practiceEndsAfterItsLastRoundAndSaysSo() {
    BlockProgress progress =
        progress(
            block(
                List.of(factor("quality", List.of("a", "b"))),
                0,
                Optional.of(new PracticeCriterion(1, 2)),
                Optional.empty()));
    for (int trial = 0; trial < 8; trial++) {
      progress.add(result(progress.next().orElseThrow(), Optional.of(false)));
    }
    assertThat(progress.next()).isEmpty();
    assertThat(progress.failed()).isTrue();
  }

  @Test
  void anOrderThatWasRecordedIsKeptThoughTheStudyHasChanged() {
    TrialBlock block =
        block(List.of(factor("quality", List.of("a", "b"))), 0, Optional.empty(), Optional.empty());
    List<TrialKey> recorded =
        List.of(new TrialKey(Map.of("quality", "b"), 0), new TrialKey(Map.of("quality", "a"), 0));
    assertThat(new BlockProgress(block, ALL, 0, 11, Map.of(1, recorded)).order())
        .extracting(trial -> trial.levels().get("quality"))
        .containsExactly("b", "a");
  }

  /** Known answer: an observer of 70.7 % at the level 12 of 24 makes 2-down 1-up converge there. */
  @Test
  void aStaircaseFindsTheLevelOfAnObserver() {
    List<String> levels = IntStream.range(0, 24).mapToObj(Integer::toString).toList();
    TrialBlock block =
        block(
            List.of(factor("detail", levels), factor("room", List.of("hall", "bath"))),
            0,
            Optional.empty(),
            Optional.of(new TrialStaircase("detail", 2, 12, 4, 200)));
    double sum = 0;
    int estimates = 0;
    Random random = new Random(5);
    for (int observer = 0; observer < 40; observer++) {
      BlockProgress progress = new BlockProgress(block, ALL, observer, 11, Map.of());
      while (progress.next().isPresent()) {
        Trial trial = progress.next().orElseThrow();
        int level = Integer.parseInt(trial.levels().get("detail"));
        double correct = 0.5 + 0.5 / (1 + Math.exp((level - 12) / 1.5 + Math.log(0.586 / 0.414)));
        progress.add(result(trial, Optional.of(random.nextDouble() < correct)));
      }
      assertThat(progress.estimates()).hasSize(2);
      for (BlockProgress.StaircaseEstimate estimate : progress.estimates()) {
        assertThat(estimate.value()).isEqualTo(estimate.level());
        sum += estimate.level();
        estimates++;
      }
    }
    assertThat(sum / estimates).isBetween(11.0, 13.0);
  }

  @Test
  void theResultsAloneDetermineTheNextTrialOfAStaircase() {
    List<String> levels = IntStream.range(0, 8).mapToObj(Integer::toString).toList();
    TrialBlock block =
        block(
            List.of(factor("detail", levels), factor("room", List.of("hall", "bath"))),
            0,
            Optional.empty(),
            Optional.of(new TrialStaircase("detail", 1, 4, 0, 20)));
    BlockProgress first = progress(block);
    List<TrialResult> results = new ArrayList<>();
    for (int trial = 0; trial < 9; trial++) {
      TrialResult given = result(first.next().orElseThrow(), Optional.of(trial % 3 != 0));
      results.add(given);
      first.add(given);
    }
    BlockProgress resumed = progress(block);
    results.forEach(
        given -> {
          assertThat(resumed.next().orElseThrow().id()).isEqualTo(given.trial());
          resumed.add(given);
        });
    assertThat(resumed.next()).isEqualTo(first.next());
  }
}
