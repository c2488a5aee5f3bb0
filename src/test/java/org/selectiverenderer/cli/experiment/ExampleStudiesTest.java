package org.selectiverenderer.cli.experiment;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.selectiverenderer.cli.CommandTestCase;

/**
 * Each example study goes from its plan through simulated trials to its report, without a display,
 * and finds what R's afex finds.
 */
class ExampleStudiesTest extends CommandTestCase {
  @TempDir Path folder;

  private Path simulated(String study, String effects) {
    Path trials = folder.resolve("trials.csv");
    List<String> command =
        new ArrayList<>(
            List.of(
                "experiment",
                "simulate",
                "--study",
                "docs/examples/" + study,
                "--output",
                trials.toString()));
    for (String effect : effects.split(";")) {
      command.addAll(List.of("--effect", effect));
    }
    assertThat(execute(command.toArray(String[]::new))).as(messages()).isZero();
    return trials;
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "rooms-between | quality=high:there+1 | Being there | 2.147",
        "quality-and-light | quality=reduced:ms+80;quality=reduced,light=dim:correct-0.15"
            + " | Time to find | 37.806",
        "change-blindness | change=shape:ms-60 | Time to see the change | 38.165",
        "levels-of-detail | side=left:correct-0.05 | Corners that are seen | 6.236"
      })
  void anExampleGoesFromPlanToReport(String study, String effects, String analysis, String f)
      throws IOException {
    assertThat(execute("experiment", "plan", "docs/examples/" + study)).as(messages()).isZero();
    Path trials = simulated(study, effects);
    Path report = folder.resolve("report.txt");
    assertThat(
            execute(
                "experiment",
                "analyse",
                "docs/examples/" + study,
                "--data",
                trials.toString(),
                "--output",
                report.toString()))
        .as(messages())
        .isZero();
    assertThat(Files.readString(report))
        .contains(analysis + " (as planned)")
        .containsPattern("Cells: [a-z.]+ of participants")
        .contains(f)
        .doesNotContain("exploratory");
  }

  @Test
  void theReportIsHtmlAndJsonToo() throws IOException {
    Path trials = simulated("quality-and-light", "quality=reduced:ms+80");
    String data = trials.toString();
    String study = "docs/examples/quality-and-light/study.json";
    Path report = folder.resolve("report");
    assertThat(
            execute(
                "experiment",
                "analyse",
                study,
                "--data",
                data,
                "--exploratory",
                "--format",
                "json",
                "--output",
                report.toString()))
        .as(messages())
        .isZero();
    assertThat(Files.readString(report))
        .contains("\"status\": \"as planned\"", "\"status\": \"exploratory\"")
        .contains("\"hypothesis\": \"Responses take longer in reduced quality, in any light.\"")
        .contains("\"source\": \"trials.csv\"");
    assertThat(
            execute(
                "experiment",
                "analyse",
                study,
                "--data",
                data,
                "--format",
                "html",
                "--output",
                report.toString()))
        .as(messages())
        .isZero();
    assertThat(Files.readString(report)).contains("<h2>Time to find (as planned)</h2>", "<svg");
  }

  @Test
  void optionsOfStudiesAndOfTablesAreToldApart() throws IOException {
    Path table = folder.resolve("r.csv");
    Files.writeString(table, "participant\n");
    assertThat(execute("experiment", "analyse", table.toString(), "--exploratory")).isEqualTo(2);
    assertThat(messages()).contains("--data and --exploratory need a study");
    assertThat(execute("experiment", "analyse", "docs/examples/rooms-between", "--family", "holm"))
        .isEqualTo(2);
    assertThat(messages()).contains("for answers about remembered objects, not for a study");
    assertThat(execute("experiment", "analyse", "docs/examples/rooms-between")).isNotZero();
    assertThat(messages()).contains("there are no trials to analyse");
  }
}
