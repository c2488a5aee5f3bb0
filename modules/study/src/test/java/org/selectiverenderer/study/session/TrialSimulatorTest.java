package org.selectiverenderer.study.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.formats.csv.CsvRow;
import org.selectiverenderer.formats.csv.CsvTable;

class TrialSimulatorTest {
  private static final Path EXAMPLES = Path.of("docs/examples");

  private static LoadedStudy study(String name) throws IOException {
    ProblemCollector problems = new ProblemCollector();
    return LoadedStudy.read(EXAMPLES.resolve(name).resolve("study.json"), problems)
        .orElseThrow(() -> new AssertionError(problems.list()));
  }

  private static TrialSimulator simulator(String name, long seed, String... effects)
      throws IOException {
    List<SimulatedEffect> parsed = new ArrayList<>();
    for (String effect : effects) {
      parsed.add(SimulatedEffect.of(effect).orElseThrow());
    }
    return new TrialSimulator(study(name), parsed, seed);
  }

  private static CsvTable table(String csv) {
    return CsvTable.parse(
            "trials.csv",
            csv,
            (at, message) -> {
              throw new AssertionError(at + message);
            })
        .orElseThrow();
  }

  /** Returns the means of a column by the cells of another one. */
  private static Map<String, Double> means(CsvTable table, String column, String by) {
    Map<String, List<Double>> all = new LinkedHashMap<>();
    for (CsvRow row : table.rows()) {
      String cell = row.cell(column);
      all.computeIfAbsent(row.cell(by), first -> new ArrayList<>())
          .add(cell.equals("yes") ? 1.0 : cell.equals("no") ? 0.0 : Double.parseDouble(cell));
    }
    Map<String, Double> means = new LinkedHashMap<>();
    all.forEach(
        (level, values) ->
            means.put(
                level, values.stream().mapToDouble(Double::doubleValue).average().orElseThrow()));
    return means;
  }

  @Test
  void aSeedGivesTheSameTrialsAndAnotherSeedOthers() throws IOException {
    String first = simulator("quality-and-light", 7).csv(4);
    assertThat(simulator("quality-and-light", 7).csv(4)).isEqualTo(first);
    assertThat(simulator("quality-and-light", 8).csv(4)).isNotEqualTo(first);
    // More participants do not change those before them.
    assertThat(simulator("quality-and-light", 7).csv(5)).startsWith(first);
  }

  @Test
  void theColumnsAreThoseOfCollectedTrialsAndPracticeIsLeftOut() throws IOException {
    CsvTable table = table(simulator("change-blindness", 1).csv(1));
    assertThat(table.header())
        .startsWith("participant", "session", "group", "block", "trial", "round", "change")
        .contains("object", "side", "response", "ms", "correct")
        .endsWith("sure.sure")
        .doesNotHaveDuplicates();
    assertThat(table.rows()).hasSize(120).allMatch(row -> row.cell("block").equals("main"));
    assertThat(table.rows())
        .allMatch(
            row ->
                row.cell("correct").equals("yes") == row.cell("response").equals(row.cell("side")));
  }

  @Test
  void anEffectOnTimeIsFoundAtItsLevel() throws IOException {
    Map<String, Double> without =
        means(table(simulator("quality-and-light", 1).csv(24)), "ms", "quality");
    Map<String, Double> with =
        means(
            table(simulator("quality-and-light", 1, "quality=reduced:ms+80").csv(24)),
            "ms",
            "quality");
    assertThat(with.get("full")).isEqualTo(without.get("full"));
    assertThat(with.get("reduced") - without.get("reduced")).isCloseTo(80, Offset.offset(0.5));
  }

  @Test
  void anEffectOnCorrectResponsesAtTwoLevelsIsNotAtOneOfThem() throws IOException {
    CsvTable table =
        table(simulator("quality-and-light", 1, "quality=reduced,light=dim:correct-0.3").csv(24));
    Map<String, List<Double>> shares = new LinkedHashMap<>();
    for (CsvRow row : table.rows()) {
      shares
          .computeIfAbsent(row.cell("quality") + row.cell("light"), first -> new ArrayList<>())
          .add(row.cell("correct").equals("yes") ? 1.0 : 0.0);
    }
    assertThat(shares).hasSize(4);
    shares.forEach(
        (cell, values) ->
            assertThat(values.stream().mapToDouble(Double::doubleValue).average().orElseThrow())
                .as(cell)
                .isCloseTo(cell.equals("reduceddim") ? 0.55 : 0.85, Offset.offset(0.08)));
  }

  @Test
  void anEffectOnAScaleShiftsItsAnswersWithinTheScale() throws IOException {
    CsvTable with = table(simulator("rooms-between", 1, "quality=high:there+3").csv(54));
    Map<String, Double> means = means(with, "there.there", "quality");
    assertThat(means.get("high")).isGreaterThan(means.get("mixed") + 1);
    assertThat(with.rows())
        .allMatch(row -> row.cell("there.there").matches("[0-9]|10"), "an answer of the scale");
  }

  @Test
  void aStaircaseGetsHarderUntilResponsesAreGuesses() throws IOException {
    CsvTable table = table(simulator("levels-of-detail", 1).csv(6));
    Map<String, Double> correct = means(table, "correct", "corners");
    assertThat(correct.get("4")).isGreaterThan(correct.getOrDefault("16", 0.5));
    assertThat(table.rows()).hasSizeBetween(6 * 20, 6 * 100);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '"',
      value = {
        "qualty=full:ms+1 | 'qualty' is neither a factor nor a column of the stimuli",
        "quality=ful:ms+1 | the factor quality has no level 'ful'",
        "quality=full:height+1 | 'height' is none of ms, correct and the scales that trials ask"
      })
  void anEffectThatCanDoNothingIsToldWhy(String effect, String fault) throws IOException {
    assertThat(simulator("quality-and-light", 1).fault(SimulatedEffect.of(effect).orElseThrow()))
        .contains(fault);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '"',
      value = {"quality", "quality=full", "quality=full:ms", "=full:ms+1", "a=b,a=c:ms+1", ":ms+1"})
  void whatIsNoEffectIsNone(String text) {
    assertThat(SimulatedEffect.of(text)).isEqualTo(Optional.empty());
  }

  @Test
  void tooManyTrialsAreRefused() throws IOException {
    TrialSimulator simulator = simulator("change-blindness", 1);
    assertThatThrownBy(() -> simulator.csv(5000))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("5000 participants would have more than 500000 trials");
  }
}
