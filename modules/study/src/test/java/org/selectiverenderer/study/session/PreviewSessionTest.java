package org.selectiverenderer.study.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.ProblemCollector;

/** A preview begins where it is told to, in shorter time, and leaves the study alone. */
class PreviewSessionTest {
  @TempDir Path folder;
  @TempDir Path apart;

  private LoadedStudy material() throws IOException {
    Files.writeString(
        folder.resolve("room.x3d"), "<X3D><Scene><Viewpoint DEF='Door'/></Scene></X3D>");
    Path file = folder.resolve("study.json");
    Files.writeString(
        file,
        """
        {"name": "Rooms", "scene": "room.x3d", "conditions": ["high"], "participants": 2,
         "areas": [{"name": "hall", "viewpoint": "Door", "seconds": 60},
                   {"name": "bath", "viewpoint": "Door", "seconds": 30}]}
        """);
    return LoadedStudy.read(file, new ProblemCollector()).orElseThrow();
  }

  @Test
  void itBeginsAtItsStepAndKeepsItsDataApart() throws IOException {
    try (Session session =
        PreviewSession.begin(
            material(), apart, "exposure-bath", 10, true, "test", new ProblemCollector())) {
      assertThat(session.remaining()).extracting(SessionStep::id).containsExactly("exposure-bath");
      assertThat(session.group()).isPresent();
      assertThat(session.material().study().area("bath").orElseThrow().seconds()).isEqualTo(3);
      assertThat(session.material().study().fade()).isEqualTo(0.1);
      assertThat(session.folder().path()).startsWith(apart);
    }
    assertThat(folder.resolve("participants.tsv")).doesNotExist();
    assertThat(folder.resolve("sub-preview")).doesNotExist();
  }

  @Test
  void aStepThatIsNotThereIsNamedWithThoseThatAre() throws IOException {
    LoadedStudy material = material();
    assertThatThrownBy(
            () ->
                PreviewSession.begin(
                    material, apart, "bath", 10, true, "test", new ProblemCollector()))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("exposure-bath");
  }
}
