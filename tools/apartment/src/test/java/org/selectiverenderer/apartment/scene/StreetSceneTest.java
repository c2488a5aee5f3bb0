package org.selectiverenderer.apartment.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.control.ControlEvent;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.walkthrough.Walkthrough;
import org.selectiverenderer.walkthrough.timeline.TimelineEvent;

/** Many apartments in one scene. */
class StreetSceneTest {
  @TempDir Path folder;

  @Test
  void fourApartmentsStandInTwoRowsAndTheSameNumberGivesTheSameBytes() {
    String text = StreetScene.text(4);

    assertThat(text)
        .isEqualTo(StreetScene.text(4))
        .contains("<meta name='title' content='street-4.x3d'/>", "4 apartments of the thesis")
        .containsSubsequence(
            "translation='0 0 0'",
            "translation='20 0 0'",
            "translation='0 0 20'",
            "translation='20 0 20'");
    assertThat(text.split("apartment\\.x3d", -1)).hasSize(5);
  }

  @Test
  void everyApartmentHasItsOwnObjectsAndAreas() throws IOException {
    copy(Path.of("scenes", "apartment.x3d"));
    try (Stream<Path> models = Files.list(Path.of("inlineNodes"))) {
      models.filter(Files::isRegularFile).forEach(this::copy);
    }
    copy(Path.of("inlineNodes", "textures"));
    try (Stream<Path> pictures = Files.list(Path.of("inlineNodes", "textures"))) {
      pictures.forEach(this::copy);
    }
    Path street = folder.resolve("scenes").resolve(StreetScene.fileName(2));
    Files.writeString(street, StreetScene.text(2));
    List<Problem> problems = new ArrayList<>();
    List<ControlEvent> events = new ArrayList<>();
    try (Walkthrough walk =
        Walkthrough.open(
            street,
            SelectiveController.Settings.SELECTIVE,
            problems::add,
            event -> events.add(((TimelineEvent.ControllerEvent) event).event()),
            text -> {})) {
      walk.step(0, (viewer, time, dt) -> viewer.moveTo(new Vector3d(0, -0.7, 0.1)));
      assertThat(walk.world().scene().root().nodes("children")).hasSizeGreaterThan(2);
      walk.step(1, (viewer, time, dt) -> viewer.moveTo(new Vector3d(-5.4, -0.7, -0.5)));
      assertThat(walk.enteredAreas()).hasSize(1);
    }

    assertThat(problems).isEmpty();
    assertThat(events).hasAtLeastOneElementOfType(ControlEvent.SwitchChange.class);
  }

  private void copy(Path file) {
    Path to = folder.resolve(file.toString());
    try {
      Files.createDirectories(to.getParent());
      Files.copy(file, to);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
