package org.selectiverenderer.statistics.script;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.assertj.core.data.Percentage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.formats.csv.CsvRow;
import org.selectiverenderer.formats.csv.CsvTable;
import org.selectiverenderer.statistics.anova.Anova;
import org.selectiverenderer.statistics.anova.AnovaOptions;
import org.selectiverenderer.statistics.anova.Factor;
import org.selectiverenderer.statistics.anova.FactorialDesign;
import org.selectiverenderer.statistics.anova.SphericityCorrection;
import org.selectiverenderer.statistics.anova.Subject;
import org.selectiverenderer.statistics.data.Measurement;
import org.selectiverenderer.statistics.script.DesignScript.Model;
import org.selectiverenderer.testing.RequiresProgram;

class DesignScriptTest {
  /** Names that would run a command, end a string or fill in a place of the template. */
  private static final List<String> HOSTILE =
      List.of(
          "x\"); file.create(\"hacked\"); c(\"",
          "\\\"); file.create('hacked') #",
          "@ANALYSES@ @DATA@",
          "line\nfile.create(\"hacked\")\n",
          "nul\0 \ud800 \u202e %s $1 \\U{41}",
          "=cmd|' /C calc'!A0");

  @TempDir private Path folder;

  private static List<Measurement> values(String first, String second) {
    Random random = new Random(5);
    List<Measurement> values = new ArrayList<>();
    for (int participant = 1; participant <= 12; participant++) {
      double own = random.nextGaussian();
      for (String level : List.of(first, second)) {
        for (int trial = 0; trial < 4; trial++) {
          values.add(
              new Measurement(
                  "p" + participant,
                  List.of(participant % 2 == 0 ? "even" : "odd", level),
                  own + (level.equals(second) ? 0.5 : 0) + random.nextGaussian()));
        }
      }
    }
    return values;
  }

  private static Model model(String name, String factor, boolean mixed, List<Measurement> values) {
    return new Model(
        name, List.of("parity", factor), List.of("parity"), false, mixed, false, values);
  }

  /** Returns the parts of the script that are outside of strings and comments. */
  private static String code(String script) {
    return script.replaceAll("\"(?:[^\"\\\\]|\\\\.)*\"", "\"\"").replaceAll("#[^\n]*", "");
  }

  @Test
  void namesAreStringsAndNeverCode() {
    String plain = code(new DesignScript(List.of(model("n", "f", true, List.of()))).script("d"));
    for (String hostile : HOSTILE) {
      String script =
          new DesignScript(List.of(model(hostile, hostile, true, List.of()))).script("d");
      assertThat(code(script)).as(hostile).isEqualTo(plain);
      assertThat(script.chars()).allMatch(c -> c == '\n' || c >= ' ' && c <= '~');
    }
  }

  @Test
  void theTableHasOnlyNamesThatRKeeps() {
    String table =
        new DesignScript(List.of(model("n", "f", false, values("=a\0\n", "full-1.5")))).data();
    assertThat(table)
        .startsWith("analysis,participant,f1,f2,f3,f4,f5,value\n1,p1,odd,unnamed 3,,,,")
        .contains("1,p1,odd,full-1.5,,,,")
        .doesNotContain("=a");
  }

  @Test
  void effectsHaveTheNamesOfTheFactors() {
    Model model = model("n", "light", false, List.of());
    assertThat(DesignScript.effect(model, "f1:f2")).isEqualTo("parity x light");
    assertThat(DesignScript.effect(model, "f3")).isEqualTo("f3");
    assertThat(DesignScript.effect(model, "")).isEmpty();
  }

  @Test
  @RequiresProgram("Rscript")
  void rFindsTheSameFAndNothingElseHappens() throws IOException, InterruptedException {
    requirePackages();
    List<Measurement> plain = values("a", "b");
    List<Model> models = new ArrayList<>(List.of(model("plain", "level", true, plain)));
    HOSTILE.forEach(name -> models.add(model(name, name, false, values(name + "1", name + "2"))));
    DesignScript script = new DesignScript(models);
    Files.write(folder.resolve("d.csv"), script.data().getBytes(StandardCharsets.UTF_8));
    Files.writeString(folder.resolve("a.R"), script.script("d.csv"));
    Path output = folder.resolve("output.txt");
    int status =
        new ProcessBuilder("Rscript", "a.R", "results.csv")
            .directory(folder.toFile())
            .redirectErrorStream(true)
            .redirectOutput(output.toFile())
            .start()
            .waitFor();
    assertThat(status).as(Files.readString(output)).isZero();
    assertThat(folder.resolve("hacked")).doesNotExist();
    List<CsvRow> rows =
        CsvTable.parse(
                "results.csv",
                Files.readAllBytes(folder.resolve("results.csv")),
                (at, message) -> {
                  throw new AssertionError(at + message);
                })
            .orElseThrow()
            .rows();
    Anova ours =
        Anova.of(design(plain), AnovaOptions.DEFAULT.withSphericity(SphericityCorrection.NONE));
    for (int analysis = 1; analysis <= models.size(); analysis++) {
      String number = Integer.toString(analysis);
      List<CsvRow> own =
          rows.stream()
              .filter(
                  row -> row.cell("analysis").equals(number) && row.cell("model").equals("anova"))
              .toList();
      assertThat(own)
          .as(Files.readString(output))
          .extracting(row -> row.cell("effect"))
          .containsExactly("f1", "f2", "f1:f2");
      for (CsvRow row : own) {
        String name = row.cell("effect").equals("f1:f2") ? "level x parity" : "";
        double f =
            ours.effects().stream()
                .filter(
                    effect ->
                        name.isEmpty()
                            ? effect
                                .name()
                                .equals(row.cell("effect").equals("f1") ? "parity" : "level")
                            : effect.name().equals(name))
                .findFirst()
                .orElseThrow()
                .f();
        assertThat(Double.parseDouble(row.cell("value")))
            .isCloseTo(f, Percentage.withPercentage(1e-6));
      }
    }
    assertThat(rows)
        .filteredOn(row -> row.cell("model").startsWith("linear mixed model, (1"))
        .extracting(row -> row.cell("effect"))
        .containsExactly("f1", "f2", "f1:f2");
  }

  private static FactorialDesign design(List<Measurement> values) {
    List<Subject> subjects = new ArrayList<>();
    for (int participant = 1; participant <= 12; participant++) {
      String id = "p" + participant;
      subjects.add(
          new Subject(
              id,
              participant % 2 == 0 ? 1 : 0,
              List.of(mean(values, id, "a"), mean(values, id, "b"))));
    }
    return new FactorialDesign(
        "value",
        new Factor("level", List.of("a", "b")),
        new Factor("parity", List.of("odd", "even")),
        subjects);
  }

  private static double mean(List<Measurement> values, String participant, String level) {
    return values.stream()
        .filter(each -> each.participant().equals(participant) && each.levels().contains(level))
        .mapToDouble(Measurement::value)
        .average()
        .orElseThrow();
  }

  /** R may be there without them; a build that must have R must have them too. */
  private static void requirePackages() throws IOException, InterruptedException {
    boolean there =
        new ProcessBuilder(
                    "Rscript",
                    "-e",
                    "quit(status = !(requireNamespace('afex') && requireNamespace('lmerTest')))")
                .redirectErrorStream(true)
                .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                .start()
                .waitFor()
            == 0;
    assumeTrue(there, "R has no packages afex and lmerTest (r-cran-afex, r-cran-lmertest)");
  }
}
