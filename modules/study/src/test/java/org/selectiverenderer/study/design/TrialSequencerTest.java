package org.selectiverenderer.study.design;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.selectiverenderer.schema.Condition;
import org.selectiverenderer.study.design.TrialBlock.Order;
import org.selectiverenderer.study.design.TrialBlock.Pairing;

class TrialSequencerTest {
  private static final StudyGroup ALL = StudyGroup.of(List.of()).get(0);

  private static Factor factor(String name, String... levels) {
    return new Factor(
        name,
        Factor.Scope.WITHIN,
        List.of(levels).stream()
            .map(level -> new Factor.Level(level, TrialSettings.NONE))
            .toList());
  }

  private static StimulusList stimuli(int count, String column, String... values) {
    List<StimulusList.Stimulus> rows = new ArrayList<>();
    for (int row = 0; row < count; row++) {
      rows.add(
          new StimulusList.Stimulus(
              row + 2,
              Map.of("item", "i" + row, column, values[row % values.length]),
              TrialSettings.NONE));
    }
    return new StimulusList(Path.of("list.csv"), List.of("item", column), rows);
  }

  private static TrialBlock block(
      List<Factor> factors,
      Optional<StimulusList> stimuli,
      Pairing pairing,
      Order order,
      Map<String, Integer> runs) {
    return new TrialBlock(
        "main",
        factors,
        stimuli,
        pairing,
        1,
        order,
        runs,
        TrialSettings.NONE,
        List.of(new TrialPhase.Instruction("{quality} {item}")),
        0,
        Optional.empty(),
        Optional.empty());
  }

  private static List<Trial> trials(TrialBlock block, int turn) {
    return new TrialSequencer(block, ALL, 7).trials(turn, 1).orElseThrow();
  }

  private static final List<Factor> TWO_BY_TWO =
      List.of(factor("quality", "high", "low"), factor("light", "day", "night"));

  @Test
  void aLatinSquareOfTwoByTwoHasEachCombinationAtEachPlaceAndAfterEachOtherOnce() {
    TrialBlock block =
        block(TWO_BY_TWO, Optional.empty(), Pairing.CROSSED, Order.LATIN_SQUARE, Map.of());
    Map<List<Object>, Integer> places = new HashMap<>();
    Set<List<Object>> pairs = new HashSet<>();
    for (int turn = 0; turn < 4; turn++) {
      List<Trial> trials = trials(block, turn);
      for (int at = 0; at < 4; at++) {
        places.merge(List.of(at, trials.get(at).levels()), 1, Integer::sum);
        if (at > 0) {
          pairs.add(List.of(trials.get(at - 1).levels(), trials.get(at).levels()));
        }
      }
    }
    assertThat(places).hasSize(16).allSatisfy((place, times) -> assertThat(times).isOne());
    assertThat(pairs).hasSize(12);
  }

  @Test
  void allOrdersComeOnceBeforeOneComesAgain() {
    TrialBlock block =
        block(
            List.of(factor("quality", "a", "b", "c")),
            Optional.empty(),
            Pairing.CROSSED,
            Order.FULL,
            Map.of());
    Set<List<Object>> orders = new LinkedHashSet<>();
    for (int turn = 0; turn < 6; turn++) {
      orders.add(List.copyOf(trials(block, turn).stream().map(Trial::levels).toList()));
    }
    assertThat(orders).hasSize(6);
    assertThat(trials(block, 6)).isEqualTo(trials(block, 0));
  }

  @Test
  void rowsAndCombinationsAreCrossedOrRotated() {
    Factor quality = factor("quality", "high", "low");
    StimulusList list = stimuli(4, "room", "hall");
    TrialBlock crossed =
        block(List.of(quality), Optional.of(list), Pairing.CROSSED, Order.FIXED, Map.of());
    assertThat(trials(crossed, 0)).hasSize(8);
    TrialBlock rotated =
        block(List.of(quality), Optional.of(list), Pairing.ROTATED, Order.FIXED, Map.of());
    Map<String, Set<String>> seen = new LinkedHashMap<>();
    for (int turn = 0; turn < 2; turn++) {
      List<Trial> trials = trials(rotated, turn);
      assertThat(trials).hasSize(4);
      trials.forEach(
          trial ->
              seen.computeIfAbsent(trial.stimulus().get("item"), item -> new HashSet<>())
                  .add(trial.levels().get("quality")));
    }
    assertThat(seen.values()).hasSize(4).containsOnly(Set.of("high", "low"));
  }

  /** An order that always came with the same pairing would show the same stimuli first to all. */
  @ParameterizedTest
  @EnumSource(
      value = Order.class,
      names = {"LATIN_SQUARE", "FULL"})
  void eachStimulusComesFirstAndLastInEachCombination(Order order) {
    TrialBlock rotated =
        block(
            List.of(factor("quality", "high", "low")),
            Optional.of(stimuli(4, "room", "hall")),
            Pairing.ROTATED,
            order,
            Map.of());
    Set<String> seen = new HashSet<>();
    for (int turn = 0; turn < 4; turn++) {
      for (Trial trial : trials(rotated, turn)) {
        seen.add(
            trial.stimulus().get("item")
                + trial.levels().get("quality")
                + (trial.number() <= 2 ? " first" : " last"));
      }
    }
    assertThat(seen).hasSize(4 * 2 * 2);
  }

  @Test
  void aColumnWithTheNameOfAFactorDeterminesItsLevel() {
    TrialBlock block =
        block(
            List.of(factor("quality", "high", "low")),
            Optional.of(stimuli(3, "quality", "low", "high")),
            Pairing.CROSSED,
            Order.FIXED,
            Map.of());
    assertThat(trials(block, 0))
        .extracting(trial -> trial.levels().get("quality"))
        .containsExactly("low", "high", "low");
  }

  @Test
  void aRandomOrderKeepsItsLimitsOfRunsAndIsEachParticipantsOwn() {
    TrialBlock block =
        block(
            List.of(factor("quality", "high", "low")),
            Optional.of(stimuli(60, "room", "hall", "bath", "attic")),
            Pairing.CROSSED,
            Order.RANDOM,
            Map.of("quality", 2, "room", 1));
    Set<List<String>> orders = new HashSet<>();
    for (int turn = 0; turn < 5; turn++) {
      List<Trial> trials = trials(block, turn);
      assertThat(trials).hasSize(120).isEqualTo(trials(block, turn));
      for (int at = 1; at < trials.size(); at++) {
        assertThat(trials.get(at).stimulus().get("room"))
            .isNotEqualTo(trials.get(at - 1).stimulus().get("room"));
        if (at > 1) {
          assertThat(
                  Set.of(
                          trials.get(at).levels().get("quality"),
                          trials.get(at - 1).levels().get("quality") + "'",
                          trials.get(at - 2).levels().get("quality") + "''")
                      .size())
              .isEqualTo(3);
          assertThat(
                  trials.subList(at - 2, at + 1).stream()
                      .map(trial -> trial.levels().get("quality"))
                      .distinct())
              .hasSize(2);
        }
      }
      orders.add(trials.stream().map(trial -> trial.stimulus().get("item")).toList());
    }
    assertThat(orders).hasSize(5);
  }

  @Test
  void limitsThatNoOrderKeepsAreTold() {
    TrialBlock block =
        block(
            List.of(factor("quality", "high", "low")),
            Optional.of(stimuli(4, "room", "hall")),
            Pairing.CROSSED,
            Order.RANDOM,
            Map.of("room", 1));
    assertThat(new TrialSequencer(block, ALL, 7).trials(0, 1)).isEmpty();
  }

  @Test
  void aMoreSpecialSettingReplacesAMoreGeneralOne() {
    TrialSettings level = TrialSettings.of(Condition.SELECTIVE);
    Factor quality =
        new Factor(
            "quality",
            Factor.Scope.WITHIN,
            List.of(
                new Factor.Level("selective", level),
                new Factor.Level("same", TrialSettings.NONE)));
    StudyGroup group = StudyGroup.of(Condition.HIGH);
    TrialBlock block =
        block(List.of(quality), Optional.empty(), Pairing.CROSSED, Order.FIXED, Map.of());
    List<Trial> trials = new TrialSequencer(block, group, 7).trials(0, 1).orElseThrow();
    assertThat(trials)
        .extracting(trial -> trial.settings().condition().orElseThrow())
        .containsExactly(Condition.SELECTIVE, Condition.HIGH);
    assertThat(trials.get(0).levels())
        .containsExactly(Map.entry("condition", "high"), Map.entry("quality", "selective"));
  }

  @Test
  void anAreaOfALevelBringsItsViewpointAndDuration() {
    TrialSettings block =
        new TrialSettings(
            Optional.empty(),
            Map.of(),
            Optional.empty(),
            Optional.empty(),
            Optional.of("Door"),
            OptionalDouble.of(9),
            Optional.empty(),
            Optional.empty(),
            OptionalDouble.empty());
    TrialSettings level =
        new TrialSettings(
            Optional.empty(),
            Map.of(),
            Optional.empty(),
            Optional.of("kitchen"),
            Optional.empty(),
            OptionalDouble.empty(),
            Optional.empty(),
            Optional.empty(),
            OptionalDouble.empty());
    assertThat(level.over(block).viewpoint()).isEmpty();
    assertThat(level.over(block).seconds()).isEmpty();
    assertThat(TrialSettings.NONE.over(block).viewpoint()).contains("Door");
  }

  @Test
  void textsNameLevelsAndCells() {
    TrialBlock block =
        block(
            List.of(factor("quality", "high", "low")),
            Optional.of(stimuli(1, "room", "hall")),
            Pairing.CROSSED,
            Order.FIXED,
            Map.of());
    assertThat(trials(block, 0))
        .extracting(trial -> trial.phases().get(0))
        .containsExactly(
            new TrialPhase.Instruction("high i0"), new TrialPhase.Instruction("low i0"));
  }
}
