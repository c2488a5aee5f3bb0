package org.selectiverenderer.validation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.validation.run.RuleCatalogue;
import org.selectiverenderer.validation.run.Validator;

/** Files that are there but may not be opened, which the superuser never meets. */
class UnreadableFileTest {
  private static final String SCENE =
      "<X3D profile='Immersive' version='4.0'><Scene>%s</Scene></X3D>";

  @TempDir Path folder;
  private Path locked = Path.of("");

  @BeforeEach
  void lock() throws IOException {
    locked = Files.writeString(folder.resolve("locked.x3d"), SCENE.formatted(""));
    assumeThat(locked.toFile().setReadable(false)).isTrue();
    assumeThat(Files.isReadable(locked)).as("the superuser reads everything").isFalse();
  }

  @Test
  void anInlineOfItIsAFinding() throws IOException {
    Path scene = folder.resolve("scene.x3d");
    Files.writeString(scene, SCENE.formatted("<Inline url='\"locked.x3d\"'/>"));
    assertThat(validate(scene).findings())
        .singleElement()
        .satisfies(finding -> assertThat(finding.rule().id()).isEqualTo("SR309"));
  }

  @Test
  void aSceneThatTheUserNamesIsAFailure() {
    assertThatThrownBy(() -> validate(locked)).isInstanceOf(AccessDeniedException.class);
  }

  private ValidationReport validate(Path scene) throws IOException {
    return new Validator(RuleCatalogue.standard(), ValidationSettings.standard(), folder)
        .validate(List.of(SourceFile.of(scene, folder)));
  }
}
