package org.selectiverenderer.base.problem;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class ProblemCollectorTest {
  @Test
  void aFileWithAMillionProblemsCostsBoundedMemory() {
    ProblemCollector problems = new ProblemCollector();
    for (int i = 0; i < 1_000_000; i++) {
      problems.error(new SourceLocation("a.x3d", i + 1, 1), "bad number");
    }
    problems.warning(new SourceLocation("b.x3d", 1, 1), "another file is still heard");

    assertThat(problems.list()).hasSize(ProblemCollector.LIMIT + 2);
    assertThat(problems.list().get(ProblemCollector.LIMIT).message()).contains("not listed");
    assertThat(problems.any()).isTrue();
  }

  @Test
  void informationIsNoProblem() {
    ProblemCollector problems = new ProblemCollector();
    problems.info(SourceLocation.of("a.x3d"), "kept");
    assertThat(problems.any()).isFalse();
  }

  @Test
  void aPlaceReadsAsTerminalsLinkIt() {
    assertThat(new Problem(Problem.Severity.ERROR, new SourceLocation("a.x3d", 3, 7), "no"))
        .hasToString("a.x3d:3:7: no");
    assertThat(SourceLocation.of("a.x3d")).hasToString("a.x3d");
  }
}
