package org.selectiverenderer.study.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.study.definition.Study;
import org.selectiverenderer.study.definition.StudyReader;

/** The room on the disk that a session needs. */
class DiskRoomTest {
  @TempDir Path folder;

  @Test
  void tooLittleRoomIsSaidInASentence() {
    assertThat(new DiskRoom(DiskRoom.LEAST).warning()).isEmpty();
    assertThat(new DiskRoom(DiskRoom.LEAST - 1).warning())
        .contains("the disk with the study's folder has 199 MB left; make room before a session");
    assertThat(new DiskRoom(20_000).warning().orElseThrow()).contains("has 0 MB left");
  }

  @Test
  void theRoomIsThatOfTheStudysDisk() throws IOException {
    Path file = folder.resolve("study.json");
    Files.writeString(
        file,
        "{\"name\": \"S\", \"conditions\": [\"high\"], \"participants\": 1,"
            + " \"questionnaires\": [{\"template\": \"sus\"}]}");
    Study study = StudyReader.read(file, new ProblemCollector()).orElseThrow();
    assertThat(DiskRoom.of(study).free()).isBetween(0L, Files.getFileStore(folder).getTotalSpace());
  }
}
