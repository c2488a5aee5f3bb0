package org.selectiverenderer.cli.experiment;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.files.Sha256;
import org.selectiverenderer.cli.CommandTestCase;

class ExperimentCommandsTest extends CommandTestCase {
  @TempDir Path folder;
  private String data = "";

  @BeforeEach
  void measurements() throws IOException {
    Path file = folder.resolve("d.csv");
    Files.writeString(
        file,
        """
        id,type,group,score
        1,c,high,1.0
        1,i,high,0.5
        2,c,high,1.2
        2,i,high,0.9
        3,c,low,0.3
        3,i,low,0.8
        4,c,low,0.1
        4,i,low,0.7
        5,c,low,0.5
        5,i,low,0.6
        """);
    data = file.toString();
  }

  @Test
  void anovaWritesTheKeysThatProgramsReadByTheColumnsNames() throws IOException {
    assertThat(anova("--within", "type", "--between", "group", "--format", "json")).isZero();
    JsonNode json = new ObjectMapper().readTree(out.toByteArray());
    assertThat(json.get("effects").findValuesAsText("effect"))
        .containsExactly("group", "type", "type x group");
    for (String key : List.of("ss", "df1", "df2", "ms", "F", "p", "partial_eta2")) {
      assertThat(json.get("effects").get(0).get(key).isNumber()).as(key).isTrue();
    }
    assertThat(json.get("descriptives")).hasSize(4);
    assertThat(json.get("descriptives").get(0).get("within").asText()).isEqualTo("c");
    assertThat(json.get("descriptives").get(0).get("between").asText()).isEqualTo("high");
    assertThat(json.get("descriptives").get(0).get("mean").asDouble()).isEqualTo(1.1);
    assertThat(json.get("descriptives").get(0).get("n").asInt()).isEqualTo(2);
    assertThat(text(err)).isEmpty();
  }

  @Test
  void anovaOfOneFactorIsOneWayOrRepeatedMeasures() {
    assertThat(anova("--within", "type")).isZero();
    assertThat(text(out)).contains("type", "Pillai's trace").doesNotContain("type x group");
  }

  /** Two within factors of two levels, two groups, an age: eight participants. */
  @Test
  void anovaOfSeveralFactorsAndACovariate() throws IOException {
    StringBuilder table = new StringBuilder("id,type,size,group,age,score\n");
    for (int i = 0; i < 8; i++) {
      for (int cell = 0; cell < 4; cell++) {
        table.append(
            "%d,%s,%s,%s,%d,%.3f\n"
                .formatted(
                    i,
                    cell < 2 ? "c" : "i",
                    cell % 2 == 0 ? "small" : "large",
                    i < 4 ? "high" : "low",
                    20 + i * i % 7,
                    Math.sin(i * 4.0 + cell * cell)));
      }
    }
    Files.writeString(Path.of(data), table);
    String[] design = {"--within", "type", "--within", "size", "--between", "group"};
    List<String> options = new ArrayList<>(List.of(design));
    options.addAll(List.of("--covariate", "age", "--correction", "gg", "--format", "json"));
    assertThat(anova(options.toArray(String[]::new))).isZero();
    JsonNode json = new ObjectMapper().readTree(out.toByteArray());
    assertThat(json.get("effects").findValuesAsText("effect"))
        .containsExactly(
            "group",
            "age",
            "type",
            "type x group",
            "type x age",
            "size",
            "size x group",
            "size x age",
            "type x size",
            "type x size x group",
            "type x size x age");
    assertThat(json.get("effects").get(0).get("bf01_undefined").asText()).contains("covariates");
    assertThat(json.get("options").get("sphericity_correction").asText()).isEqualTo("gg");
    assertThat(json.get("descriptives").get(0).get("within").asText()).isEqualTo("c, small");
    out.reset();
    options = new ArrayList<>(List.of(design));
    options.addAll(List.of("--prior", "0.707", "--format", "json"));
    assertThat(anova(options.toArray(String[]::new))).isZero();
    json = new ObjectMapper().readTree(out.toByteArray());
    assertThat(json.get("effects")).hasSize(7);
    for (JsonNode effect : json.get("effects")) {
      assertThat(effect.get("bf01").asDouble()).isPositive();
      assertThat(effect.get("bf01_robustness")).hasSize(7);
    }
    assertThat(json.get("options").get("prior_fixed").asDouble()).isEqualTo(0.707);
    assertThat(json.get("assumptions").get("levene")).hasSize(4);
    out.reset();
    assertThat(anova("--between", "group", "--covariate", "group")).isEqualTo(2);
    assertThat(anova("--within", "type", "--prior", "0")).isEqualTo(2);
    assertThat(text(err)).contains("--prior must be a number from 0.01 to 10");
  }

  @Test
  void anovaOfABadTableIsStatusOneAndNamesThePlace() throws IOException {
    Files.writeString(Path.of(data), Files.readString(Path.of(data)).replace("0.7", "\"0,7\""));
    assertThat(anova("--within", "type", "--between", "group")).isEqualTo(1);
    assertThat(text(err))
        .contains(
            "d.csv:9:9: participant 4: '0,7' has a decimal comma where '1.0' in line 2 has a decimal point")
        .hasLineCount(1);
    assertThat(text(out)).contains("Data that are missing or left out");
  }

  @Test
  void anovaWithoutEnoughParticipantsIsStatusOneAndNoReport() throws IOException {
    Files.writeString(Path.of(data), "id,type,group,score\n1,c,high,1\n2,c,low,2\n");
    assertThat(anova("--between", "group")).isEqualTo(1);
    assertThat(text(err)).contains("no degrees of freedom for the error; nothing is analysed");
    assertThat(text(out)).isEmpty();
  }

  @Test
  void wrongUsageIsStatusTwo() {
    assertThat(anova()).isEqualTo(2);
    assertThat(text(err)).contains("--within, --between or both");
    assertThat(anova("--within", "type", "--bounds", "-1")).isEqualTo(2);
    assertThat(anova("--within", "type", "--between", "type")).isEqualTo(2);
    assertThat(anova("--within", "type", "--output", folder.resolve("no/x").toString()))
        .isEqualTo(2);
    assertThat(execute("experiment", "nothing")).isEqualTo(2);
    assertThat(execute("experiment", "simulate", "--d-prime", "1,2")).isEqualTo(2);
    assertThat(execute("experiment", "simulate", "--power", "--area", "attic")).isEqualTo(2);
    assertThat(text(err)).doesNotContain("\tat ");
  }

  @Test
  void powerThatCannotBeComputedIsRefusedAtOnce() {
    assertThat(execute("experiment", "simulate", "--power", "--participants", "3")).isEqualTo(2);
    assertThat(text(err)).contains("--participants must be more than the number of conditions, 3");
    assertThat(execute("experiment", "simulate", "--needed", "--goal", "type", "--area", "office"))
        .isEqualTo(2);
    assertThat(text(err))
        .contains(
            "--goal type is not tested by such studies of the office; choose condition, equivalence");
    assertThat(
            execute("experiment", "simulate", "--needed", "--conditions", "a", "--area", "office"))
        .isEqualTo(2);
    assertThat(text(err)).contains("--needed has nothing to look for: one condition");
  }

  @Test
  void aSimulatedStudyGoesThroughTheWholeAnalysis() throws IOException {
    Path answers = folder.resolve("r.csv");
    assertThat(
            execute(
                "experiment",
                "simulate",
                "--participants",
                "12",
                "--d-prime",
                "0.8,1.1,1.4",
                "--output",
                answers.toString()))
        .isZero();
    for (String format : List.of("text", "json", "html", "tidy", "wide")) {
      Path report = folder.resolve("report." + format);
      assertThat(
              execute(
                  "experiment",
                  "analyse",
                  answers.toString(),
                  "--format",
                  format,
                  "--output",
                  report.toString()))
          .isZero();
      assertThat(report).isNotEmptyFile();
    }
    JsonNode json = new ObjectMapper().readTree(folder.resolve("report.json").toFile());
    assertThat(json.get("analyses")).hasSize(6 * 3 * 3);
    assertThat(json.get("scores")).hasSize(12 * 9 * 3);
    assertThat(text(err)).isEmpty();
  }

  @Test
  void partsOfAReportAreWrittenIntoFoldersAndNeverOverTheAnswers() throws IOException {
    Path r = Files.createDirectory(folder.resolve("r"));
    Path answers = r.resolve("usable-answers.csv");
    Files.writeString(answers, simulated(12));
    String before = Files.readString(answers);
    String name = answers.toString();
    assertThat(execute("experiment", "analyse", name, "--r", r.toString())).isEqualTo(2);
    assertThat(text(err)).contains("--r", "which is read");
    assertThat(answers).hasContent(before);
    Path figures = folder.resolve("out/figures");
    Path tables = folder.resolve("out/tables");
    Path script = folder.resolve("out/r");
    assertThat(
            execute(
                "experiment",
                "analyse",
                name,
                "--figures",
                figures.toString(),
                "--tables",
                tables.toString(),
                "--r",
                script.toString(),
                "--family",
                "fdr",
                "--date",
                "2026-05-01"))
        .isZero();
    assertThat(text(out).replaceAll("\\s+", " "))
        .contains(" on 2026-05-01 from usable-answers.csv, SHA-256 ");
    assertThat(figures.resolve("kitchen-d_prime-all.svg")).content().contains("<svg");
    assertThat(tables.resolve("kitchen-effects.csv")).content().contains("p corrected");
    assertThat(tables.resolve("methods.txt")).content().contains("Benjamini & Hochberg, 1995");
    assertThat(script.resolve("usable-answers.csv")).hasContent(before);
    assertThat(script.resolve("analysis.R")).content().contains("glmer");
    assertThat(execute("experiment", "analyse", name, "--figures", name)).isEqualTo(2);
    assertThat(text(err)).contains("is a file, not a folder");
    assertThat(execute("experiment", "analyse", name, "--date", "yesterday")).isEqualTo(2);
    assertThat(text(err)).contains("--date must be a day such as 2026-05-01, not yesterday");
  }

  @Test
  void reportsForProgramsAreTheSameBytesEveryDayAndNameTheirInput() throws IOException {
    Path answers = folder.resolve("r.csv");
    Files.writeString(answers, simulated(12));
    for (String format : List.of("json", "tidy", "wide")) {
      assertThat(execute("experiment", "analyse", answers.toString(), "--format", format)).isZero();
      assertThat(text(out))
          .contains(Sha256.of(Files.readAllBytes(answers)))
          .doesNotContain(LocalDate.now().toString());
    }
    assertThat(anova("--within", "type", "--format", "json")).isZero();
    assertThat(text(out)).contains(Sha256.of(Files.readAllBytes(Path.of(data))));
  }

  @Test
  void powerIsPrintedAndProgressGoesToTheErrorStream() {
    assertThat(
            execute("experiment", "simulate", "--power", "--participants", "12", "--studies", "20"))
        .isZero();
    assertThat(text(out)).contains("20 simulated studies of 12 participants", "condition");
    assertThat(text(err)).contains("simulate: 12 participants: 20 of 20 studies");
  }

  @Test
  void aReportIsNotWrittenOverTheAnswersItIsMadeOf() throws IOException {
    Path answers = folder.resolve("r.csv");
    Files.writeString(answers, simulated(12));
    String before = Files.readString(answers);
    String name = answers.toString();
    assertThat(execute("experiment", "analyse", name, "--format", "tidy", "--output", name))
        .isEqualTo(2);
    assertThat(text(err)).contains("which is read");
    assertThat(answers).hasContent(before);
    assertThat(anova("--within", "type", "--output", data)).isEqualTo(2);
    assertThat(Path.of(data)).content().startsWith("id,type");
  }

  @Test
  void aTableThatWasFilledInIsNotWrittenOver() throws IOException {
    Path study = folder.resolve("study.json");
    Files.writeString(
        study,
        """
        {"name": "One room", "conditions": ["high"], "participants": 4,
         "questionnaires": [{"kind": "recognition", "items": "items.csv"}]}
        """);
    Files.writeString(
        folder.resolve("items.csv"),
        "area,object,consistency,present,en\nhall,coat,consistent,yes,Coat\n");
    Path table = folder.resolve("001.csv");
    List<String> paper =
        List.of(
            "experiment",
            "paper",
            study.toString(),
            "--participant",
            "001",
            "--condition",
            "high",
            "--csv",
            table.toString());
    assertThat(execute(paper.toArray(String[]::new))).isZero();
    assertThat(execute(paper.toArray(String[]::new))).isZero();
    String filled = Files.readString(table).replace("yes,,", "yes,no,4");
    Files.writeString(table, filled);
    assertThat(execute(paper.toArray(String[]::new))).isEqualTo(2);
    assertThat(text(err)).contains("perhaps answers; it is not overwritten");
    String name = table.toString();
    List<String> collect =
        List.of("experiment", "collect", study.toString(), "--paper", name, "--responses");
    assertThat(execute(with(collect, name))).isEqualTo(2);
    assertThat(table).hasContent(filled);
    Path all = folder.resolve("all.csv");
    assertThat(execute(with(collect, all.toString()))).isZero();
    assertThat(all).hasContent(filled);
    assertThat(text(err))
        .contains(
            "collected: 1 answer of 1 participant (rows of the tables: recognition answers: 1)")
        .doesNotContain("not written");
    Path scores = folder.resolve("scores.csv");
    List<String> other =
        List.of("experiment", "collect", study.toString(), "--paper", name, "--scores");
    assertThat(execute(with(other, scores.toString()))).isZero();
    assertThat(text(err)).contains("not written: recognition answers (--responses F.csv)");
    Path trials = folder.resolve("trials.csv");
    List<String> ofTrials =
        List.of("experiment", "collect", study.toString(), "--paper", name, "--trials");
    assertThat(execute(with(ofTrials, trials.toString()))).isZero();
    assertThat(text(err)).contains("trials: 0; those of practice blocks are written with");
  }

  private static String[] with(List<String> arguments, String last) {
    List<String> all = new ArrayList<>(arguments);
    all.add(last);
    return all.toArray(String[]::new);
  }

  private int analyse(String answers, Charset charset) throws IOException {
    Path file = folder.resolve("r.csv");
    Files.writeString(file, answers, charset);
    return execute("experiment", "analyse", file.toString());
  }

  private String simulated(int participants) {
    execute("experiment", "simulate", "--participants", Integer.toString(participants));
    return text(out);
  }

  @Test
  void whatCannotBeTestedIsSaidWithItsPlaceAndIsStatusOne() throws IOException {
    String good = simulated(12);
    assertThat(analyse(good.replaceAll("(?m)^.*,(high-low|selective),.*\\R", ""), UTF_8)).isOne();
    assertThat(text(err))
        .startsWith(folder.resolve("r.csv") + ":2:1: there is one condition only, high; ");
    assertThat(text(out)).doesNotContain("NaN");
    assertThat(analyse(simulated(3), UTF_8)).isOne();
    assertThat(text(err).lines())
        .hasSize(6)
        .allMatch(line -> line.contains("leave no degrees of freedom for the error"));
    String perfect =
        good.replaceAll("(?m),yes,(yes|no),\\d$", ",yes,yes,5")
            .replaceAll("(?m),no,(yes|no),\\d$", ",no,no,5");
    assertThat(analyse(perfect, UTF_8)).isOne();
    assertThat(text(err).lines())
        .hasSize(6)
        .allMatch(
            line ->
                line.matches(
                    ".*r\\.csv:\\d+:1: d′, log β, c of the area .* cannot be tested: .*variance.*"));
    assertThat(text(out)).doesNotContain("NaN");
  }

  @Test
  void otherEncodingsAreToldByLineAndColumn() throws IOException {
    String greek = simulated(3).replace(",lounge,", ",σαλόνι,");
    assertThat(analyse(greek, StandardCharsets.UTF_16LE)).isOne();
    assertThat(text(err)).contains("r.csv:1:1: ", "UTF-16").hasLineCount(1);
    assertThat(analyse(greek, Charset.forName("windows-1253"))).isOne();
    assertThat(text(err))
        .containsPattern("r\\.csv:\\d+:\\d+: the file is not UTF-8")
        .hasLineCount(1);
    assertThat(analyse("a,\"b\",\"c\n1,2\n", UTF_8)).isOne();
    assertThat(text(err)).contains("r.csv:1:7: the file is not valid CSV").hasLineCount(1);
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  void aFullDiskAndAFolderAreNamed() throws IOException {
    Files.writeString(folder.resolve("r.csv"), simulated(12));
    String answers = folder.resolve("r.csv").toString();
    assertThat(execute("experiment", "analyse", answers, "--output", "/dev/full")).isEqualTo(2);
    assertThat(text(err)).contains("/dev/full: No space left").hasLineCount(1);
    assertThat(execute("experiment", "analyse", folder.toString())).isEqualTo(2);
    assertThat(text(err)).contains(folder + ": is a folder").hasLineCount(1);
  }

  private int anova(String... options) {
    List<String> args =
        new ArrayList<>(List.of("experiment", "anova", data, "--dv", "score", "--subject", "id"));
    args.addAll(List.of(options));
    return execute(args.toArray(String[]::new));
  }
}
