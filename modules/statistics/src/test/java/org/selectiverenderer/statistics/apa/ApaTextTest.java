package org.selectiverenderer.statistics.apa;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.selectiverenderer.statistics.anova.Anova;
import org.selectiverenderer.statistics.anova.AnovaOptions;
import org.selectiverenderer.statistics.anova.Factor;
import org.selectiverenderer.statistics.anova.FactorialDesign;
import org.selectiverenderer.statistics.anova.Subject;

class ApaTextTest {
  @ParameterizedTest
  @CsvSource({"0.109,.109", "0.0004,< .001", "0.001,.001", "0.9996,> .999", "1,> .999", "NaN,–"})
  void pHasNoZeroBeforeThePointAndIsNeverZero(double p, String text) {
    assertThat(ApaNumberFormat.p(p)).isEqualTo(text);
  }

  @Test
  void whatCanExceedOneKeepsItsZero() {
    assertThat(ApaNumberFormat.of(-0.345, 2)).isEqualTo("−0.35");
    assertThat(ApaNumberFormat.share(-0.345, 2)).isEqualTo("−.35");
    assertThat(ApaNumberFormat.share(1, 2)).isEqualTo("1.00");
    assertThat(ApaNumberFormat.of(-0.001, 2)).isEqualTo("0.00");
    assertThat(ApaNumberFormat.df(51)).isEqualTo("51");
    assertThat(ApaNumberFormat.df(1.634)).isEqualTo("1.63");
    assertThat(ApaNumberFormat.bayes(123456)).isEqualTo("1.2e+05");
    assertThat(ApaNumberFormat.withP("p", 0.0001)).isEqualTo("p < .001");
  }

  @Test
  void aTestIsOneSentencePart() {
    Anova anova =
        anova(List.of(List.of(1.0, 2.0, 3.0, 4.0, 5.0), List.of(3.5, 4.5, 5.5, 6.5, 7.5)));
    // F = 6.25, p = .0369 (R: pf(6.25, 1, 8, lower.tail = FALSE)), eta² = 6.25 / 14.25
    assertThat(ApaSentences.test(anova.effects().get(0)))
        .startsWith("F(1, 8) = 6.25, p = .037, ηp² = .44, 90% CI [.02, .")
        .endsWith("]");
  }

  @Test
  void withoutVarianceThereIsNoFAndTheReason() {
    Anova anova = anova(List.of(List.of(1.0, 1.0), List.of(1.0, 1.0)));
    assertThat(ApaSentences.test(anova.effects().get(0)))
        .startsWith("no F is defined (the error has zero variance");
  }

  @Test
  void aTableHasThreeFormsThatEscapeWhatTheyMust() {
    ApaTable table =
        new ApaTable(
            "effects",
            "Title & more",
            List.of("Area_1", "F", "ηp²"),
            1,
            List.of(List.of("a < b, 100%", "−1.5", ".08")),
            "d′ of {all}.");
    assertThat(table.html())
        .contains(
            "<i>Title &amp; more</i>",
            "<th>Area_1</th><th><i>F</i></th>",
            "<td class=\"words\">a &lt; b, 100%</td><td>−1.5</td>",
            "<i>Note.</i> d′ of {all}.");
    assertThat(table.latex())
        .contains(
            "\\caption{Title \\& more}",
            "{lrr}",
            "Area\\_1 & \\textit{F} & $\\eta_p^2$ \\\\",
            "a $<$ b, 100\\% & $-$1.5 & .08 \\\\",
            "$d'$ of \\{all\\}.");
    assertThat(table.csv()).isEqualTo("Area_1,F,ηp²\n\"a < b, 100%\",-1.5,.08\n");
  }

  private static Anova anova(List<List<Double>> groups) {
    List<Subject> subjects = new ArrayList<>();
    for (int group = 0; group < groups.size(); group++) {
      for (double value : groups.get(group)) {
        subjects.add(new Subject("s" + subjects.size(), group, List.of(value)));
      }
    }
    return Anova.of(
        new FactorialDesign(
            "y",
            new Factor("level", List.of("all")),
            new Factor("group", List.of("a", "b")),
            subjects),
        AnovaOptions.DEFAULT);
  }
}
