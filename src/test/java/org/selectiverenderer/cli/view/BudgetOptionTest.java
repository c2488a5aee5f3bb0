package org.selectiverenderer.cli.view;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.selectiverenderer.cli.CommandTestCase;

/** A budget on the command line, with the trash can in the office. */
class BudgetOptionTest {
  private final CommandTestCase command = new CommandTestCase();

  private int simulate(String... more) {
    String[] all = new String[more.length + 4];
    all[0] = "simulate";
    all[1] = "scenes/trashcan.x3d";
    all[2] = "--path";
    all[3] = "scenes/paths/desk-visit.csv";
    System.arraycopy(more, 0, all, 4, more.length);
    return command.execute(all);
  }

  @Test
  void aLargeBudgetShowsTheBestVersionAndAreasSwitchNothing() {
    assertThat(simulate("--budget", "triangles:1000000")).isZero();
    assertThat(command.messages()).isEmpty();
    assertThat(command.printed().lines().filter(line -> line.contains("  switch  ")))
        .allMatch(line -> line.endsWith("choice 1 -> 0 (budget)"))
        .hasSizeLessThanOrEqualTo(1);
    assertThat(command.printed()).contains("enter   DeskProx activates DeskSchema");
  }

  @Test
  void aBudgetThatCannotBeKeptIsTold() {
    assertThat(simulate("--budget", "triangles:1")).isZero();
    assertThat(command.messages())
        .hasLineCount(1)
        .contains("trashcan.x3d: the budget of 1 triangles is less than the ")
        .contains(" of the scene with the smallest versions of all objects, which are shown");
  }

  @Test
  void aSceneWithoutObjectsToChooseFromIsTold() {
    assertThat(
            command.execute(
                "simulate",
                "scenes/hello.x3d",
                "--path",
                "scenes/paths/desk-visit.csv",
                "--budget",
                "triangles:1"))
        .isZero();
    assertThat(command.messages())
        .contains("of the scene, in which no object has versions with metadata to choose from");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "--budget|ms:16|--budget ms:16 needs frames that are drawn",
        "--budget|16|is no budget; give triangles:N",
        "--budget|triangles:0|is no budget",
        "--budget=triangles:9|--condition=high|--budget chooses the versions itself"
      })
  void whatCannotBeIsRefusedInOneLine(String option, String value, String refused) {
    assertThat(simulate(option, value)).isEqualTo(2);
    assertThat(command.messages()).contains(refused);
  }
}
