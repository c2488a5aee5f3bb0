package org.selectiverenderer.statistics.anova;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.selectiverenderer.statistics.bayes.BayesianAnova;

class AnovaTest {
  private static final Offset<Double> EXACT = within(1e-12);

  /** Groups 1 2 3 and 3 4 8: means 2 and 5, SS between 13.5, within 2 + 14. */
  @Test
  void aOneWayDesignByHand() {
    Anova anova = Anova.of(oneWay(new double[][] {{1, 2, 3}, {3, 4, 8}}), AnovaOptions.DEFAULT);
    assertThat(anova.effects()).hasSize(1);
    Effect group = anova.effects().get(0);
    assertThat(group.name()).isEqualTo("group");
    assertThat(group.ss()).isEqualTo(13.5, EXACT);
    assertThat(group.errorSs()).isEqualTo(16, EXACT);
    assertThat(group.df1()).isEqualTo(1);
    assertThat(group.df2()).isEqualTo(4);
    assertThat(group.f()).isEqualTo(3.375, EXACT);
    assertThat(group.partialEta().value()).isEqualTo(13.5 / 29.5, EXACT);
    PairwiseComparison pair = anova.comparisons().get(0);
    assertThat(pair.difference()).isEqualTo(-3, EXACT);
    assertThat(pair.t() * pair.t()).isEqualTo(3.375, EXACT);
    assertThat(pair.p()).isEqualTo(group.p(), EXACT);
  }

  @Test
  void generalisedEtaOfAOneWayDesignIsThePartialOneWithSteigersInterval() {
    Effect group =
        Anova.of(oneWay(new double[][] {{1, 2, 3}, {3, 4, 8}}), AnovaOptions.DEFAULT)
            .effects()
            .get(0);
    assertThat(group.generalisedEta().value()).isEqualTo(group.partialEta().value(), EXACT);
    assertThat(group.generalisedEta().low()).isEqualTo(group.partialEta().low(), EXACT);
    assertThat(group.generalisedEta().high()).isEqualTo(group.partialEta().high(), EXACT);
  }

  @Test
  void scoresThatDoNotVaryWithinGroupsHaveNoFAndSayWhy() {
    Effect group =
        Anova.of(oneWay(new double[][] {{0.1, 0.1, 0.1}, {0.7, 0.7, 0.7}}), AnovaOptions.DEFAULT)
            .effects()
            .get(0);
    assertThat(group.f()).isNaN();
    assertThat(group.flaw()).hasValueSatisfying(why -> assertThat(why).contains("zero variance"));
  }

  @Test
  void aDifferenceThatIsTheSameForAllHasNoWithinFButABetweenF() {
    FactorialDesign design =
        new FactorialDesign(
            "y",
            new Factor("level", List.of("a", "b")),
            new Factor("group", List.of("x", "y")),
            List.of(
                new Subject("1", 0, List.of(0.1, 0.4)),
                new Subject("2", 0, List.of(0.2, 0.5)),
                new Subject("3", 1, List.of(1.7, 2.0)),
                new Subject("4", 1, List.of(1.2, 1.5))));
    Anova anova = Anova.of(design, AnovaOptions.DEFAULT);
    assertThat(anova.effect(EffectKind.BETWEEN).orElseThrow().f()).isFinite();
    Effect within = anova.effect(EffectKind.WITHIN).orElseThrow();
    assertThat(within.f()).isNaN();
    assertThat(within.multivariate()).isEmpty();
    assertThat(within.flaw()).isPresent();
    assertThat(
            anova.comparisons().stream()
                .filter(pair -> pair.factor().equals("level"))
                .map(PairwiseComparison::t))
        .isNotEmpty()
        .allMatch(t -> t.isNaN());
  }

  @Test
  void moreLevelsThanParticipantsLeaveTheMultivariateTestsOut() {
    FactorialDesign design =
        new FactorialDesign(
            "y",
            new Factor("level", List.of("a", "b", "c", "d")),
            new Factor("group", List.of("all")),
            List.of(
                new Subject("1", 0, List.of(1.0, 2.0, 4.0, 3.0)),
                new Subject("2", 0, List.of(2.0, 2.5, 3.0, 5.0)),
                new Subject("3", 0, List.of(0.5, 2.0, 1.0, 4.0))));
    Effect level = Anova.of(design, AnovaOptions.DEFAULT).effects().get(0);
    assertThat(level.f()).isFinite();
    assertThat(level.multivariate()).isEmpty();
    assertThat(level.flaw()).hasValueSatisfying(why -> assertThat(why).contains("multivariate"));
    assertThat(level.sphericity().orElseThrow().mauchlyP()).isNaN();
  }

  @Test
  void fewerParticipantsThanGroupsOrNothingToCompareIsAnObstacle() {
    assertThat(oneWay(new double[][] {{1}, {2}}).obstacle())
        .contains("2 participants in 2 groups leave no degrees of freedom for the error");
    Factor one = new Factor("group", List.of("all"));
    Factor two = new Factor("level", List.of("a", "b"));
    assertThat(
            new FactorialDesign("y", two, one, List.of(new Subject("1", 0, List.of(1.0, 2.0))))
                .obstacle())
        .contains("1 participant in 1 group leaves no degrees of freedom for the error");
    assertThat(oneWay(new double[][] {{1, 2, 3}}).obstacle())
        .hasValueSatisfying(why -> assertThat(why).contains("nothing to compare"));
    assertThat(oneWay(new double[][] {{1, 2}, {}}).obstacle())
        .contains("there is no participant with complete data in the group g1");
    FactorialDesign design = oneWay(new double[][] {{1}, {2}});
    assertThatThrownBy(() -> Anova.of(design, AnovaOptions.DEFAULT))
        .isInstanceOf(IllegalArgumentException.class);
  }

  /** With two levels and two groups the interaction is one difference of differences: F = t². */
  @Test
  void theInteractionOfTwoByTwoIsItsOnlyDifferenceOfDifferences() {
    FactorialDesign design =
        new FactorialDesign(
            "y",
            new Factor("level", List.of("a", "b")),
            new Factor("group", List.of("x", "y")),
            List.of(
                new Subject("1", 0, List.of(0.1, 0.4)),
                new Subject("2", 0, List.of(0.2, 0.9)),
                new Subject("3", 1, List.of(1.7, 1.1)),
                new Subject("4", 1, List.of(1.2, 1.5)),
                new Subject("5", 1, List.of(1.0, 0.5))));
    Anova anova = Anova.of(design, AnovaOptions.DEFAULT);
    PairwiseComparison last = anova.comparisons().get(anova.comparisons().size() - 1);
    Effect interaction = anova.effect(EffectKind.INTERACTION).orElseThrow();
    assertThat(last.factor()).isEqualTo("level x group");
    assertThat(last.first()).isEqualTo("x (a − b)");
    assertThat(last.t() * last.t()).isEqualTo(interaction.f(), EXACT);
    assertThat(last.p()).isEqualTo(interaction.p(), EXACT);
  }

  @Test
  void holmTakesTheSmallestPTimesTheirNumberAndNeverFallsBack() {
    assertThat(HolmCorrection.adjusted(List.of(0.04, 0.01, 0.03)))
        .containsExactly(new double[] {0.06, 0.03, 0.06}, EXACT);
    assertThat(HolmCorrection.adjusted(List.of(0.9, 0.8))).containsExactly(1, 1);
  }

  /** Difference 0 with SE 0.2 and bounds of 0.5: both tests have t = 2.5. */
  @Test
  void equivalenceNeedsBothOneSidedTests() {
    Tost none = Tost.of(0, 0.2, 30, 0.5);
    assertThat(none.lowerT()).isEqualTo(2.5, EXACT);
    assertThat(none.upperT()).isEqualTo(-2.5, EXACT);
    assertThat(none.p()).isEqualTo(0.0090578, within(1e-7));
    assertThat(Tost.of(0.45, 0.2, 30, 0.5).p()).isGreaterThan(0.05);
    assertThat(Tost.of(0.7, 0.2, 30, 0.5).p()).isGreaterThan(0.5);
  }

  @Test
  void aSmallFSpeaksForTheNullInEveryWay() {
    double[][] same = {{1, 2, 3, 4, 5, 2, 4}, {1.1, 2, 3, 4, 4.9, 2.1, 3.9}};
    Effect group = Anova.of(oneWay(same), AnovaOptions.DEFAULT.withEtaBound(0.5)).effects().get(0);
    assertThat(group.p()).isGreaterThan(0.9);
    assertThat(group.equivalence().p()).isLessThan(0.05);
    assertThat(Anova.of(oneWay(same), AnovaOptions.DEFAULT).comparisons().get(0).bayesFactor())
        .isGreaterThan(1.5);
  }

  private static FactorialDesign oneWay(double[][] groups) {
    List<Subject> subjects = new ArrayList<>();
    List<String> names = new ArrayList<>();
    for (int group = 0; group < groups.length; group++) {
      names.add("g" + group);
      for (double value : groups[group]) {
        subjects.add(new Subject(group + "-" + subjects.size(), group, List.of(value)));
      }
    }
    return new FactorialDesign(
        "y", new Factor("level", List.of("all")), new Factor("group", names), subjects);
  }

  /**
   * A mean of ten thousand standard deviations and groups as far apart took minutes, then failed.
   */
  @Test
  @Timeout(20)
  void aVeryClearEffectHasAllItsFigures() {
    double[][] clear = {{1e4, 1e4 + 1, 1e4 + 2}, {3e4 + 3, 3e4 + 4, 3e4 + 8}};
    Anova anova = Anova.of(oneWay(clear), AnovaOptions.DEFAULT);
    Effect group = anova.effects().get(0);
    assertThat(group.partialEta().low()).isBetween(0.99999, group.partialEta().value());
    assertThat(group.partialEta().high()).isBetween(group.partialEta().value(), 1.0);
    assertThat(anova.comparisons().get(0).d().low()).isLessThan(-1000);
    assertThat(anova.intercept().partialEta().value()).isGreaterThan(0.9999);
    assertThat(anova.intercept().partialEta().low()).isNaN();
    assertThat(new BayesianAnova(anova).effects().get(0).bf01()).isBetween(0.0, 1e-10);
  }

  /** Levels as far from sphericity as can be: the third is the first and noise. */
  @Test
  void aLackOfSphericityIsActedOnUnlessItIsToldNotTo() {
    List<Subject> subjects = new ArrayList<>();
    double[] large = {5, -3, 8, -6, 1, 4, -9, 2, 7, -5};
    double[] small = {0.1, -0.2, 0.3, 0.1, -0.1, 0.2, -0.3, 0.2, 0.1, -0.2};
    for (int i = 0; i < large.length; i++) {
      subjects.add(new Subject("s" + i, 0, List.of(small[i], large[i], 1 + small[9 - i])));
    }
    FactorialDesign design =
        new FactorialDesign(
            "y",
            new Factor("level", List.of("a", "b", "c")),
            new Factor("group", List.of("all")),
            subjects);
    Effect level = Anova.of(design, AnovaOptions.DEFAULT).effects().get(0);
    CorrectedDegreesOfFreedom corrected = level.correction().orElseThrow();
    assertThat(corrected.by()).isEqualTo(SphericityCorrection.GREENHOUSE_GEISSER);
    assertThat(corrected.epsilon()).isBetween(0.5, 0.52);
    assertThat(level.testDf1()).isEqualTo(2 * corrected.epsilon(), EXACT);
    assertThat(level.p()).isEqualTo(level.correctedP(corrected.epsilon()), EXACT);
    Effect as =
        Anova.of(design, AnovaOptions.DEFAULT.withSphericity(SphericityCorrection.NONE))
            .effects()
            .get(0);
    assertThat(as.correction()).isEmpty();
    assertThat(as.p()).isEqualTo(level.uncorrectedP(), EXACT);
    assertThat(as.equivalence().p()).isNotEqualTo(level.equivalence().p());
    assertThat(as.partialEta().high()).isNotEqualTo(level.partialEta().high());
    Effect huynh =
        Anova.of(design, AnovaOptions.DEFAULT.withSphericity(SphericityCorrection.HUYNH_FELDT))
            .effects()
            .get(0);
    assertThat(huynh.correction().orElseThrow().by()).isEqualTo(SphericityCorrection.HUYNH_FELDT);
  }

  @Test
  void aCovariateThatTheGroupsTellIsRefused() {
    List<Subject> subjects = new ArrayList<>();
    for (int i = 0; i < 8; i++) {
      subjects.add(new Subject("s" + i, i % 2, List.of(i * 0.7), List.of(3.0 + i % 2)));
    }
    Factor none = new Factor("level", List.of("all"));
    Factor group = new Factor("group", List.of("x", "y"));
    FactorialDesign design =
        new FactorialDesign("y", List.of(none), List.of(group), List.of("age"), subjects);
    assertThat(design.obstacle())
        .contains("the covariate age is redundant: the groups predict it exactly; leave it out");
  }
}
