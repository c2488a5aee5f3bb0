package org.selectiverenderer.statistics.anova;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** What a simulation decides by is what a report says. */
class SignificanceTestsTest {
  @Test
  void everyPIsThatOfTheWholeAnalysis() {
    Random random = new Random(12);
    int corrected = 0;
    for (int groups = 1; groups <= 3; groups++) {
      for (int levels = 2; levels <= 4; levels++) {
        FactorialDesign design = design(groups, levels, 20, random);
        Anova whole = Anova.of(design, AnovaOptions.DEFAULT);
        SignificanceTests tests = SignificanceTests.of(design, AnovaOptions.DEFAULT);
        assertThat(tests.effects()).hasSameSizeAs(whole.effects());
        for (int i = 0; i < tests.effects().size(); i++) {
          Effect effect = whole.effects().get(i);
          FTestResult test = tests.effects().get(i);
          assertThat(test.term()).isEqualTo(effect.term());
          assertThat(test.f()).isEqualTo(effect.f());
          assertThat(test.p()).isEqualTo(effect.p());
          assertThat(test.df1()).isEqualTo(effect.testDf1());
          corrected += effect.correction().isPresent() ? 1 : 0;
        }
        assertThat(tests.groups())
            .isEqualTo(
                whole.comparisons().stream()
                    .filter(pair -> pair.factor().equals("group") && pair.at().isEmpty())
                    .toList());
      }
    }
    assertThat(corrected).isPositive();
  }

  @Test
  void aDesignThatCannotBeAnalysedIsRefused() {
    FactorialDesign design = design(3, 2, 3, new Random(1));
    assertThatThrownBy(() -> SignificanceTests.of(design, AnovaOptions.DEFAULT))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("degrees of freedom");
  }

  /** Later levels vary more, so that sphericity is lacking. */
  private static FactorialDesign design(int groups, int levels, int subjects, Random random) {
    List<Subject> all = new ArrayList<>();
    for (int i = 0; i < subjects; i++) {
      double own = random.nextGaussian();
      List<Double> values = new ArrayList<>();
      for (int level = 0; level < levels; level++) {
        values.add(own + (1 + 2 * level) * random.nextGaussian());
      }
      all.add(new Subject("s" + i, i % groups, values));
    }
    return new FactorialDesign("y", factor("level", levels), factor("group", groups), all);
  }

  private static Factor factor(String name, int levels) {
    List<String> names = new ArrayList<>();
    for (int level = 0; level < levels; level++) {
      names.add(name + level);
    }
    return new Factor(name, names);
  }
}
