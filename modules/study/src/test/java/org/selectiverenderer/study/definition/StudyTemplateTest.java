package org.selectiverenderer.study.definition;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.files.FileOperations;

class StudyTemplateTest {
  @TempDir private Path folder;

  @Test
  void aNetworkFolderThatDoesNotForceNamesIsAsGoodAsAny() throws IOException {
    FileOperations networkFolder =
        new FileOperations() {
          @Override
          public void forceFolder(Path forced) throws IOException {
            throw new IOException("Invalid argument");
          }
        };

    Path study =
        StudyTemplate.write(
            folder.resolve("study"), Path.of("scenes/apartment.x3d"), networkFolder);

    assertThat(study).isRegularFile();
    assertThat(folder.resolve("study/pilot/expectancy.csv")).isRegularFile();
  }

  @Test
  void aFolderWhoseNameNeedsEscapingIsNamedSoThatTheStudyIsRead() throws IOException {
    Path scenes = Files.createDirectories(folder.resolve("my \"scenes\""));
    Files.copy(Path.of("scenes/apartment.x3d"), scenes.resolve("apartment.x3d"));
    Files.copy(Path.of("scenes/practice.x3d"), scenes.resolve("practice.x3d"));

    Path study =
        StudyTemplate.write(folder.resolve("study"), scenes.resolve("apartment.x3d"), 9, 4);

    assertThat(study)
        .content()
        .contains(
            "\"scene\": \"../my \\\"scenes\\\"/apartment.x3d\"",
            "\"participants\": 9,",
            "\"seed\": 4,",
            "Lines like this one are comments.",
            "(the thesis: three groups of 18)");
    Path copy = StudyTemplate.copy(folder.resolve("study"), folder.resolve("a/copy"));
    assertThat(copy).content().contains("\"../../my \\\"scenes\\\"/apartment.x3d\"");
  }
}
