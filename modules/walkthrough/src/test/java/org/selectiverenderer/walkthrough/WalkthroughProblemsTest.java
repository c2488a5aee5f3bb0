package org.selectiverenderer.walkthrough;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.control.SelectiveController.Settings;

/** What an author hears of a scene that opens without an error. */
class WalkthroughProblemsTest {
  private static final String FILE = "<X3D version='4.0' profile='Full'><Scene>%s</Scene></X3D>";
  private static final String ENRICHED =
      "<Switch><Group/><MetadataString containerField='metadata' name='schemaBelonginess'"
          + " value='\"A\"'/></Switch>";
  private @TempDir Path dir;

  private List<Problem> problems(String nodes) throws IOException {
    Path scene = Files.writeString(dir.resolve("scene.x3d"), FILE.formatted(nodes));
    List<Problem> problems = new ArrayList<>();
    Walkthrough.open(scene, Settings.SELECTIVE, problems::add, event -> {}, line -> {}).close();
    return problems;
  }

  @Test
  void whatIsWrongWithAnInlinedRoomIsToldAtItsPlace() throws IOException {
    Files.writeString(
        dir.resolve("room.x3d"),
        FILE.formatted(
            "\n<Switch DEF='Can'><Group/><MetadataSet containerField='metadata'><MetadataString"
                + " name='schemaBelonginess' value='\"A\"'/><MetadataString"
                + " name='degreeOfConsistency' value='\"hihg\"'/></MetadataSet></Switch>"));
    assertThat(problems("<Inline url='\"room.x3d\"'/>"))
        .filteredOn(problem -> problem.severity() == Problem.Severity.WARNING)
        .singleElement()
        .satisfies(
            problem -> {
              assertThat(problem.location().file()).endsWith("room.x3d");
              assertThat(problem.location().line()).isEqualTo(2);
              assertThat(problem.message()).startsWith("Can: ");
            });
  }

  @Test
  void aSchemaThatNoAreaActivatesIsNoReasonToFail() throws IOException {
    assertThat(problems(ENRICHED))
        .extracting(Problem::severity)
        .containsExactly(Problem.Severity.INFO);
  }
}
