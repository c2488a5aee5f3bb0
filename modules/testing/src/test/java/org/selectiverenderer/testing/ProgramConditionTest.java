package org.selectiverenderer.testing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ProgramConditionTest {
  @Test
  void withoutTheProgramATestIsSkippedWithTheReason() {
    var result = ProgramCondition.decide("Rscript", false, "REQUIRE_R", false);
    assertThat(result.isDisabled()).isTrue();
    assertThat(result.getReason()).hasValue("Rscript is not on the path");
  }

  @Test
  void whereTheProgramIsRequiredItFailsInstead() {
    assertThatThrownBy(() -> ProgramCondition.decide("Rscript", false, "REQUIRE_R", true))
        .hasMessage("REQUIRE_R=1, but tests with Rscript cannot run: it is not on the path");
  }

  @Test
  void aProgramIsFoundInAnyFolderOfThePath(@TempDir Path folder) throws IOException {
    Path program = Files.createFile(folder.resolve("validate-it.exe"));
    assertThat(program.toFile().setExecutable(true)).isTrue();
    String path = folder.resolve("none") + File.pathSeparator + folder;
    assertThat(ProgramCondition.onPath("validate-it", path)).isTrue();
    assertThat(ProgramCondition.onPath("another", path)).isFalse();
  }
}
