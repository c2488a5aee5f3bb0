package org.selectiverenderer.base.problem;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class ProblemsTest {
  @Test
  void aFileWithAMillionProblemsCostsBoundedMemory() {
    Problems problems = new Problems();
    for (int i = 0; i < 1_000_000; i++) {
      problems.error(new Location("a.x3d", i + 1, 1), "bad number");
    }
    problems.warning(new Location("b.x3d", 1, 1), "another file is still heard");

    assertThat(problems.list()).hasSize(Problems.LIMIT + 2);
    assertThat(problems.list().get(Problems.LIMIT).message()).contains("not listed");
    assertThat(problems.any()).isTrue();
  }

  @Test
  void informationIsNoProblem() {
    Problems problems = new Problems();
    problems.info(Location.of("a.x3d"), "kept");
    assertThat(problems.any()).isFalse();
  }

  @Test
  void aPlaceReadsAsTerminalsLinkIt() {
    assertThat(new Problem(Problem.Severity.ERROR, new Location("a.x3d", 3, 7), "no"))
        .hasToString("a.x3d:3:7: no");
    assertThat(Location.of("a.x3d")).hasToString("a.x3d");
  }
}
