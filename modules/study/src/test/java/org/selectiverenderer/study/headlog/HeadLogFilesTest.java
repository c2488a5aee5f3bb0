package org.selectiverenderer.study.headlog;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Nobody's data are lost to a head log. */
class HeadLogFilesTest {
  @TempDir private Path folder;

  @Test
  void aLogThatIsThereIsKept() throws IOException {
    Path csv = Files.writeString(folder.resolve("p01.csv"), "an hour of a participant");
    assertThatThrownBy(() -> HeadLogFiles.claim(csv, false))
        .isInstanceOf(FileAlreadyExistsException.class)
        .hasMessageContaining("p01.csv");
    assertThat(csv).hasContent("an hour of a participant");
    assertThat(folder.resolve("p01.json")).doesNotExist();
  }

  @Test
  void aDescriptionThatIsThereIsKeptAndNothingMadeBesideIt() throws IOException {
    Path json = Files.writeString(folder.resolve("p01.json"), "{\"mine\": true}");
    assertThatThrownBy(() -> HeadLogFiles.claim(folder.resolve("p01.csv"), false))
        .isInstanceOf(FileAlreadyExistsException.class)
        .hasMessageContaining("p01.json");
    assertThat(json).hasContent("{\"mine\": true}");
    assertThat(folder.resolve("p01.csv")).doesNotExist();
  }

  @Test
  void filesTakenForALogThatNeverBeganGoAgain() throws IOException {
    HeadLogFiles.claim(folder.resolve("p01.csv"), false).close();
    assertThat(folder).isEmptyDirectory();
  }

  @Test
  void aLogToBeReplacedIsThereUntilTheNewOneBegins() throws IOException {
    Path csv =
        Files.writeString(folder.resolve("p01.csv"), "old and longer than a header\n".repeat(9));
    HeadLogFiles.claim(csv, true).close();
    assertThat(csv).content().startsWith("old and longer");
    HeadLogWriter.open(HeadLogFiles.claim(csv, true), HeadLogMetadata.UNKNOWN, problem -> {})
        .close();
    assertThat(csv)
        .hasContent(
            String.join(",", HeadLogColumn.of(false).stream().map(HeadLogColumn::header).toList())
                + "\n");
    assertThat(folder.resolve("p01.json")).isNotEmptyFile();
  }

  @Test
  void whereNothingCanBeWrittenTheFileThatWasAskedForIsNamed() {
    assertThatThrownBy(() -> HeadLogFiles.claim(folder.resolve("none/p01.csv"), false))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("p01.csv: the head log cannot be written there");
  }
}
