package org.selectiverenderer.study.definition;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
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
}
