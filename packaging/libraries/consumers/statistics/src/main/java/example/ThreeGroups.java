package example;

import java.util.List;
import java.util.Locale;
import org.selectiverenderer.statistics.anova.Anova;
import org.selectiverenderer.statistics.anova.AnovaOptions;
import org.selectiverenderer.statistics.anova.FactorialDesign;
import org.selectiverenderer.statistics.anova.Effect;
import org.selectiverenderer.statistics.anova.Factor;
import org.selectiverenderer.statistics.anova.Subject;
import org.selectiverenderer.statistics.detection.DetectionIndices;
import org.selectiverenderer.statistics.detection.ExtremeRateCorrection;
import org.selectiverenderer.statistics.detection.ResponseCounts;

/** Sensitivity of one participant, and whether three groups differ. */
public final class ThreeGroups {
  private ThreeGroups() {}

  public static void main(String[] args) {
    DetectionIndices detection =
        DetectionIndices.of(new ResponseCounts(18, 2, 5, 15), ExtremeRateCorrection.LOG_LINEAR);
    System.out.printf(
        Locale.ROOT, "d' = %.3f, c = %.3f%n", detection.dPrime(), detection.criterion());

    Factor once = new Factor("time", List.of("once"));
    Factor condition = new Factor("condition", List.of("high", "selective", "random"));
    List<Subject> subjects =
        List.of(
            new Subject("P1", 0, List.of(1.0)),
            new Subject("P2", 0, List.of(2.0)),
            new Subject("P3", 0, List.of(3.0)),
            new Subject("P4", 1, List.of(2.0)),
            new Subject("P5", 1, List.of(3.0)),
            new Subject("P6", 1, List.of(4.0)),
            new Subject("P7", 2, List.of(5.0)),
            new Subject("P8", 2, List.of(6.0)),
            new Subject("P9", 2, List.of(7.0)));
    Anova anova =
        Anova.of(new FactorialDesign("d'", once, condition, subjects), AnovaOptions.DEFAULT);
    for (Effect effect : anova.effects()) {
      System.out.printf(
          Locale.ROOT,
          "%s: F(%.0f, %.0f) = %.2f, p = %.4f, partial eta squared %.3f%n",
          effect.name(),
          effect.df1(),
          effect.df2(),
          effect.f(),
          effect.p(),
          effect.partialEta().value());
    }
  }
}
