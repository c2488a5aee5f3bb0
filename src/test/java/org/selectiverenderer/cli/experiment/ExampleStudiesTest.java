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
import org.junit.jupiter.params.provider.ValueSource;
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
        .contains("\"status\" : \"as planned\"", "\"status\" : \"exploratory\"")
        .contains("\"hypothesis\" : \"Responses take longer in reduced quality, in any light.\"")
        .contains("\"source\" : \"trials.csv\"");
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
    assertThat(messages()).contains("--data, --exploratory, --r-script and --run-r need a study");
    assertThat(execute("experiment", "analyse", "docs/examples/rooms-between", "--family", "holm"))
        .isEqualTo(2);
    assertThat(messages()).contains("for answers about remembered objects, not for a study");
    assertThat(execute("experiment", "analyse", "docs/examples/rooms-between")).isNotZero();
    assertThat(messages()).contains("there are no trials to analyse");
  }

  @Test
  void theScriptForRLiesBesideItsData() throws IOException {
    Path trials = simulated("quality-and-light", "quality=reduced:ms+80");
    Path script = folder.resolve("plan.R");
    assertThat(
            execute(
                "experiment",
                "analyse",
                "docs/examples/quality-and-light",
                "--data",
                trials.toString(),
                "--r-script",
                script.toString(),
                "--output",
                folder.resolve("report").toString()))
        .as(messages())
        .isZero();
    assertThat(Files.readString(script))
        .contains("data_file <- \"plan-data.csv\"", "labels = c(\"quality\", \"light\")");
    assertThat(Files.readString(folder.resolve("plan-data.csv")))
        .startsWith("analysis,participant,f1,f2,f3,f4,f5,value")
        .contains("1,001,full,bright,,,,", "2,001,full,bright,,,,");
  }

  @Test
  void thePowerOfThePlanIsTheSameForASeed() throws IOException {
    String[] command = {
      "experiment",
      "simulate",
      "--study",
      "docs/examples/quality-and-light",
      "--power",
      "--studies",
      "20",
      "--participants",
      "8",
      "--effect",
      "quality=reduced:ms+150"
    };
    assertThat(execute(command)).as(messages()).isZero();
    String first = printed();
    assertThat(first)
        .contains("20 simulated studies with 8 participants each, seed 1.")
        .contains("quality=reduced:ms+150")
        .containsPattern("Time to find +quality +1\\.000 \\[0\\.8")
        .containsPattern("Sensitivity +quality x light +0\\.");
    assertThat(execute(command)).isZero();
    assertThat(printed()).endsWith(first.substring(first.length() - 200));
  }

  @Test
  void withoutAPlanThereIsNoPower() throws IOException {
    assertThat(
            execute(
                "experiment",
                "new",
                folder.resolve("own").toString(),
                "--design",
                "levels-of-detail"))
        .as(messages())
        .isZero();
    Path study = folder.resolve("own/study.json");
    String text = Files.readString(study);
    int begin = text.indexOf("  \"analysis\"");
    Files.writeString(
        study, text.substring(0, begin) + text.substring(text.indexOf("  \"questionnaires\"")));
    assertThat(execute("experiment", "simulate", "--study", study.toString(), "--power"))
        .isEqualTo(2);
    assertThat(messages()).contains("--power needs a study that plans its analyses");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "change-blindness", "levels-of-detail", "quality-and-light", "rooms-between", "web"
      })
  void anExampleIsTheBeginningOfAStudyOfOnesOwn(String design) throws IOException {
    Path own = folder.resolve("own");
    assertThat(execute("experiment", "new", own.toString(), "--design", design))
        .as(messages())
        .isZero();
    assertThat(execute("experiment", "check", own.toString())).as(messages()).isZero();
    assertThat(printed()).contains("the study is sound");
    assertThat(execute("experiment", "new", own.toString(), "--design", design)).isNotZero();
    assertThat(messages()).contains("exists already; nothing was written");
  }

  @Test
  void anUnknownDesignIsToldWithTheKnownOnes() {
    assertThat(execute("experiment", "new", folder.toString(), "--design", "stroop")).isEqualTo(2);
    assertThat(messages())
        .contains(
            "'stroop' is none of change-blindness, levels-of-detail, quality-and-light,"
                + " rooms-between, web");
  }
}
