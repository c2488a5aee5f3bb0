package org.selectiverenderer.app.head;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.OffsetDateTime;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.schema.Condition;
import org.selectiverenderer.study.definition.Study;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.web.ExposureReplay;
import org.selectiverenderer.study.web.ExposureReplay.Seen;
import org.selectiverenderer.study.web.WebExposureLog;
import org.selectiverenderer.study.web.WebExposureLog.Frame;
import org.selectiverenderer.study.web.WebExposureLog.SceneEvent;

class SceneExposureReplayTest {
  private static final Path SCENE = Path.of("scenes/trashcan.x3d").toAbsolutePath();

  @TempDir Path folder;

  private Study study(Path scene) throws IOException {
    Path file = folder.resolve("study.json");
    Files.writeString(
        file,
        """
        {"name": "Office", "scene": "%s", "conditions": ["high", "selective"],
         "participants": 4, "areas": [{"name": "office", "viewpoint": "OfficeView", "seconds": 2}]}
        """
            .formatted(folder.relativize(scene).toString().replace('\\', '/')));
    return LoadedStudy.read(file, new ProblemCollector()).orElseThrow().study();
  }

  private static ExposureReplay.Exposure exposure(Study study, List<Frame> frames) {
    return new ExposureReplay.Exposure(
        study.scene(),
        study.areas().get(0).viewpoint(),
        Condition.SELECTIVE,
        study.design().group("selective").orElseThrow(),
        7,
        OffsetDateTime.parse("2026-11-01T10:00:00Z"),
        1000,
        500,
        new WebExposureLog(
            frames,
            List.of(
                new SceneEvent(0, SceneEvent.Kind.SWITCH, "Switch_TrashCan", 1),
                new SceneEvent(0.5, SceneEvent.Kind.SWITCH, "Switch_TrashCan", 0))));
  }

  private static Frame at(double t, double x, double y, double z, double yaw, double pitch) {
    return new Frame(t, x, y, z, yaw, pitch, 0, 16, true, t);
  }

  @Test
  void whatIsInViewIsFoundWithTheVersionThatThePageShowed() throws IOException {
    Study study = study(SCENE);
    ExposureReplay.Replayed seen =
        new SceneExposureReplay()
            .of(
                study,
                exposure(
                    study,
                    // From the desk down to the trash can, then up to the ceiling.
                    List.of(
                        at(0, 4.5, -0.246, 0.75, -152.1, -53.7),
                        at(1, 4.5, -0.246, 0.75, -152.1, -53.7),
                        at(2, 4.5, -0.246, 0.75, -152.1, 80))));
    assertThat(seen.frames())
        .extracting(Seen::object)
        .startsWith("Switch_TrashCan", "Switch_TrashCan")
        .last()
        .isNotEqualTo("Switch_TrashCan");
    assertThat(seen.frames()).extracting(Seen::version).containsExactly(1, 0, -1);
    assertThat(seen.frames().get(1).schemas()).containsExactly("DeskSchema");
    assertThat(seen.frames().get(0).distance()).isBetween(1.5, 2.2);
    assertThat(seen.frames().get(0).cone()).contains("Switch_TrashCan");
    assertThat(seen.description().map().areas()).isNotEmpty();
    assertThat(seen.description().display()).isEqualTo("browser window of 1000x500");
    assertThat(seen.description().tanX()).isEqualTo(2 * seen.description().tanY());
  }

  @Test
  void aSceneThatIsNotThereIsSaidInASentence() throws IOException {
    Path copy =
        Files.writeString(
            folder.resolve("hall.x3d"), "<X3D><Scene><Viewpoint DEF='OfficeView'/></Scene></X3D>");
    Study study = study(copy);
    Files.delete(copy);
    assertThatThrownBy(
            () ->
                new SceneExposureReplay().of(study, exposure(study, List.of(at(0, 0, 0, 0, 0, 0)))))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("hall.x3d");
  }
}
