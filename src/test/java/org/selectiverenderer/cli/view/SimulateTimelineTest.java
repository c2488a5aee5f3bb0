package org.selectiverenderer.cli.view;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.cli.CommandTestCase;

/**
 * The time lines of the scenes that a user opens first, against golden files. Where one differs on
 * purpose, run the command in the test's name and put its output in the file's place.
 */
class SimulateTimelineTest {

  private static List<String> command(String scene, String path, String... options) {
    List<String> args =
        new ArrayList<>(
            List.of(
                "simulate", "scenes/" + scene + ".x3d", "--path", "scenes/paths/" + path + ".csv"));
    args.addAll(List.of(options));
    return args;
  }

  /** Runs a command that is to end well and say nothing on standard error. */
  private static String run(List<String> args) {
    CommandTestCase command = new CommandTestCase();
    int status = command.execute(args.toArray(String[]::new));
    assertThat(command.messages()).isEmpty();
    assertThat(status).isZero();
    return command.printed().replace(System.lineSeparator(), "\n");
  }

  private static String golden(String name) throws IOException {
    try (InputStream in =
        Objects.requireNonNull(
            SimulateTimelineTest.class.getResourceAsStream("timelines/" + name), name)) {
      return new String(in.readAllBytes(), StandardCharsets.UTF_8).replace("\r\n", "\n");
    }
  }

  @ParameterizedTest
  @CsvSource({
    "trashcan, desk-visit, selective",
    "trashcan, desk-visit, high",
    "trashcan, desk-visit, high-low",
    "trashcan, desk-visit, random",
    "overlap, overlap-visit, selective",
    "overlap, overlap-visit, high",
    "overlap, overlap-visit, high-low",
    "overlap, overlap-visit, random"
  })
  void simulateSceneAlongPathInConditionWithSeed7(String scene, String path, String condition)
      throws IOException {
    List<String> text = command(scene, path, "--condition", condition, "--seed", "7");
    assertThat(run(text)).isEqualTo(golden(path + "-" + condition + ".txt"));
    List<String> json = new ArrayList<>(text);
    json.addAll(List.of("--format", "json"));
    assertThat(run(json)).isEqualTo(golden(path + "-" + condition + ".jsonl"));
  }

  @ParameterizedTest
  @ValueSource(strings = {"1", "10", "24.5", "1000"})
  void simulateDeskVisitAtRate(String rate) throws IOException {
    assertThat(run(command("trashcan", "desk-visit", "--format", "json", "--rate", rate)))
        .isEqualTo(golden("desk-visit-at-" + rate + ".jsonl"));
  }

  @ParameterizedTest
  @ValueSource(strings = {"el-GR", "de-DE", "tr-TR", "ar-EG-u-nu-arab", "th-TH-u-ca-buddhist"})
  void theLanguageOfTheMachineChangesNothing(String tag) throws IOException {
    Locale before = Locale.getDefault();
    Locale.setDefault(Locale.forLanguageTag(tag));
    try {
      assertThat(run(command("trashcan", "desk-visit")))
          .isEqualTo(golden("desk-visit-selective.txt"));
      assertThat(run(command("overlap", "overlap-visit", "--format", "json")))
          .isEqualTo(golden("overlap-visit-selective.jsonl"));
    } finally {
      Locale.setDefault(before);
    }
  }

  @Test
  void theSameSeedDrawsTheSameLotAndAnotherAnother() {
    List<String> lots = new ArrayList<>();
    for (int seed = 0; seed < 8; seed++) {
      List<String> args =
          command("overlap", "overlap-visit", "--condition", "random", "--seed", "" + seed);
      assertThat(run(args)).isEqualTo(run(args));
      lots.add(run(args).lines().findFirst().orElseThrow());
    }
    assertThat(lots.stream().distinct().count()).isGreaterThan(1);
  }

  @Test
  void enumsAreReadInAnyCase() throws IOException {
    Locale before = Locale.getDefault();
    Locale.setDefault(Locale.forLanguageTag("tr-TR"));
    try {
      assertThat(run(command("overlap", "overlap-visit", "--format", "JSON")))
          .isEqualTo(golden("overlap-visit-selective.jsonl"));
    } finally {
      Locale.setDefault(before);
    }
  }
}
