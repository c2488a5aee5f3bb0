package org.selectiverenderer.study.definition;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.formats.json.JsonSettingsReader;
import org.selectiverenderer.study.design.PlannedAnalysis;

/** Compares what a study plans with what a copy of its file planned before. */
public final class PlanComparison {
  private PlanComparison() {}

  /**
   * Returns whether a copy of a study file plans the same analyses in the same order; else the plan
   * was changed since the copy was made.
   *
   * @throws IOException if the copy cannot be read
   */
  public static boolean same(Study study, Path copy) throws IOException {
    List<PlannedAnalysis> before = new ArrayList<>();
    // Faults of the copy do not matter here: what it cannot say it has not planned.
    new JsonSettingsReader("a study", "the study is not used")
        .read(
            copy,
            new ProblemCollector(),
            keys -> {
              before.addAll(new PlannedAnalysesReader(study.design()).read(keys));
              return before;
            });
    List<PlannedAnalysis> now = study.design().analyses();
    boolean same = before.size() == now.size();
    for (int i = 0; same && i < now.size(); i++) {
      same = now.get(i).plansAs(before.get(i));
    }
    return same;
  }
}
