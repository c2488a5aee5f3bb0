package org.selectiverenderer.study.analysis;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.regex.Pattern;
import org.assertj.core.data.Percentage;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.formats.csv.CsvRow;
import org.selectiverenderer.formats.csv.CsvTable;
import org.selectiverenderer.statistics.anova.Anova;
import org.selectiverenderer.statistics.anova.AnovaOptions;
import org.selectiverenderer.statistics.anova.Effect;
import org.selectiverenderer.statistics.anova.SphericityCorrection;
import org.selectiverenderer.statistics.data.DataSource;
import org.selectiverenderer.statistics.data.ObservationsReader;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.session.SimulatedEffect;
import org.selectiverenderer.study.session.TrialSimulator;

/**
 * The analyses of the example studies' simulated trials agree with those of R's afex, whose table
 * src/test/scripts/designs-golden.R has made from the same trials.
 */
class DesignsAgreeWithRTest {
  private static final Path EXAMPLES = Path.of("docs/examples");

  /** A page with the table that readers see. */
  private static final Path PAGE = Path.of("docs/statistics.md");

  private static final AnovaOptions OPTIONS =
      AnovaOptions.DEFAULT.withSphericity(SphericityCorrection.NONE);

  @TempDir private Path folder;

  private static List<CsvRow> golden() throws IOException {
    try (var file =
        Objects.requireNonNull(
            DesignsAgreeWithRTest.class.getResourceAsStream("designs-golden.csv"))) {
      return CsvTable.parse(
              "designs-golden.csv",
              new String(file.readAllBytes(), StandardCharsets.UTF_8),
              (at, message) -> {
                throw new AssertionError(at + message);
              })
          .orElseThrow()
          .rows();
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "between | rooms-between | 54 | quality=high:there+1 | there.there | quality | |",
        "mixed | rooms-between | 54 | quality=high:there+1 | there.there | quality | area |",
        "time | quality-and-light | 24 | quality=reduced:ms+80;quality=reduced,light=dim:correct-0.15"
            + " | ms | | quality;light | correct=yes",
        "share | quality-and-light | 24 | quality=reduced:ms+80;quality=reduced,light=dim:correct-0.15"
            + " | correct | | quality;light |",
        "change | change-blindness | 24 | change=shape:ms-60 | ms | | change | correct=yes",
        "staircase | levels-of-detail | 20 | side=left:correct-0.05 | corners | | side |"
      })
  void eachEffectHasTheFiguresOfR(
      String design,
      String example,
      int participants,
      String effects,
      String measure,
      String between,
      String within,
      String where)
      throws IOException {
    ProblemCollector problems = new ProblemCollector();
    String trials = trials(study(example, problems), participants, effects);
    // The share of correct responses is the mean of 1 and 0.
    String counted = trials.replace(",yes", ",1").replace(",no", ",0");
    Map<String, String> rows =
        where == null ? Map.of() : Map.of("correct", where.endsWith("yes") ? "1" : "0");
    Anova anova =
        Anova.of(
            ObservationsReader.read(
                    Files.writeString(folder.resolve("trials.csv"), counted),
                    new ObservationsReader.Columns(
                        measure, "participant", list(within), list(between), List.of()),
                    new ObservationsReader.Rows(rows, true),
                    problems)
                .orElseThrow()
                .design(),
            OPTIONS);
    assertThat(problems.list()).isEmpty();
    agree(design, anova);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "mixed | rooms-between | 54 | quality=high:there+1 | Being there",
        "time | quality-and-light | 24 | quality=reduced:ms+80;quality=reduced,light=dim:correct-0.15"
            + " | Time to find",
        "sensitivity | quality-and-light | 24"
            + " | quality=reduced:ms+80;quality=reduced,light=dim:correct-0.15 | Sensitivity",
        "change | change-blindness | 24 | change=shape:ms-60 | Time to see the change",
        "threshold | levels-of-detail | 20 | side=left:correct-0.05 | Corners that are seen"
      })
  void whatAStudyPlansHasTheFiguresOfR(
      String design, String example, int participants, String effects, String analysis)
      throws IOException {
    ProblemCollector problems = new ProblemCollector();
    LoadedStudy study = study(example, problems);
    StudyTrials trials =
        StudyTrials.read(
                "trials.csv",
                trials(study, participants, effects).getBytes(StandardCharsets.UTF_8),
                DataSource.none("trials.csv"),
                study.study().design(),
                problems)
            .orElseThrow();
    TrialAnalyses.Analysis planned =
        new TrialAnalyses(study, trials)
            .planned().stream()
                .filter(each -> each.plan().name().equals(analysis))
                .findFirst()
                .orElseThrow();
    agree(design, Anova.of(planned.data(), OPTIONS));
  }

  private static LoadedStudy study(String example, ProblemCollector problems) throws IOException {
    return LoadedStudy.read(EXAMPLES.resolve(example).resolve("study.json"), problems)
        .orElseThrow(() -> new AssertionError(problems.list()));
  }

  private static String trials(LoadedStudy study, int participants, String effects) {
    List<SimulatedEffect> parsed =
        list(effects).stream().map(text -> SimulatedEffect.of(text).orElseThrow()).toList();
    return new TrialSimulator(study, parsed, 1).csv(participants);
  }

  /** Compares the effects with those of the golden table and of the page. */
  private static void agree(String design, Anova anova) throws IOException {
    List<CsvRow> expected =
        golden().stream().filter(row -> row.cell("design").equals(design)).toList();
    assertThat(anova.effects()).hasSameSizeAs(expected);
    for (CsvRow row : expected) {
      Effect effect =
          anova.effects().stream()
              .filter(each -> factors(each.name(), " x ").equals(factors(row.cell("effect"), ":")))
              .findFirst()
              .orElseThrow();
      assertThat(effect.df1()).isEqualTo(number(row, "df1"));
      assertThat(effect.df2()).isEqualTo(number(row, "df2"));
      assertThat(effect.f()).isCloseTo(number(row, "F"), Percentage.withPercentage(1e-6));
      assertThat(effect.p()).isCloseTo(number(row, "p"), Percentage.withPercentage(1e-6));
      assertThat(effect.generalisedEta().value())
          .isCloseTo(number(row, "ges"), Percentage.withPercentage(1e-6));
      assertThat(Files.readAllLines(PAGE)).contains(line(row, effect));
    }
  }

  /** Returns the line of the page, with the figures of the program beside those of R. */
  private static String line(CsvRow row, Effect effect) {
    return String.format(
        Locale.ROOT,
        "| %s | %s | %.0f, %.0f | %.5f | %.5f | %.3e | %.3e | %.5f | %.5f |",
        row.cell("design"),
        row.cell("effect").replace(":", " x "),
        effect.df1(),
        effect.df2(),
        effect.f(),
        number(row, "F"),
        effect.p(),
        number(row, "p"),
        effect.generalisedEta().value(),
        number(row, "ges"));
  }

  private static List<String> list(String text) {
    return text == null ? List.of() : List.of(text.split(";"));
  }

  private static Set<String> factors(String name, String separator) {
    return new LinkedHashSet<>(
        new ArrayList<>(Arrays.asList(name.split(Pattern.quote(separator)))));
  }

  private static double number(CsvRow row, String column) {
    return Double.parseDouble(row.cell(column));
  }
}
