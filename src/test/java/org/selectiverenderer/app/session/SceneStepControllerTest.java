package org.selectiverenderer.app.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.browser.navigation.NavigationCommand;
import org.selectiverenderer.render.window.KeyboardKey;
import org.selectiverenderer.study.session.ExperimenterControls;
import org.selectiverenderer.study.session.Session;

/** What the operator may see and do while a step is shown. */
class SceneStepControllerTest {
  private static final OperatorViewSettings OPEN =
      new OperatorViewSettings(Optional.empty(), Optional.empty(), false, false);
  private static final OperatorViewSettings IN_A_DISPLAY =
      new OperatorViewSettings(Optional.empty(), Optional.empty(), true, true);

  @TempDir private Path folder;
  private Session session;
  private ExperimenterControls controls;

  @BeforeEach
  void begin() throws IOException {
    Files.writeString(
        folder.resolve("rooms.x3d"),
        "<X3D version='4.0' profile='Immersive'><Scene><Viewpoint DEF='Here'/></Scene></X3D>");
    Path file =
        Files.writeString(
            folder.resolve("study.json"),
            """
            {"name": "Rooms", "conditions": ["selective"], "participants": 1, "scene": "rooms.x3d",
             "areas": [{"name": "hall", "viewpoint": "Here", "seconds": 1}]}
            """);
    session = StartedSession.of(file);
    controls = new ExperimenterControls(session.journal());
  }

  @AfterEach
  void end() throws IOException {
    session.close();
  }

  private SceneStepController guide(OperatorViewSettings stage) {
    return new SceneStepController(
        session,
        session.remaining().get(0),
        "Here",
        OptionalDouble.of(1),
        controls,
        stage,
        problem -> {
          throw new AssertionError(problem);
        });
  }

  @Test
  void theConditionIsToldOnlyToWhomTheStudyTellsIt() {
    assertThat(guide(OperatorViewSettings.DESK).blind()).isTrue();
    assertThat(guide(OperatorViewSettings.DESK).operatorLines(0))
        .contains("participant 001")
        .noneMatch(line -> line.contains("selective"));
    assertThat(guide(OPEN).blind()).isFalse();
    assertThat(guide(OPEN).operatorLines(0)).contains("participant 001, selective");
  }

  @Test
  void thePointerIsKeptButInPausesAndWhenTheExperimenterIsAsked() {
    SceneStepController guide = guide(IN_A_DISPLAY);
    assertThat(guide.keepsPointer()).isTrue();
    controls.pause(true);
    assertThat(guide.keepsPointer()).isFalse();
    controls.pause(false);
    controls.asking(true);
    assertThat(guide.keepsPointer()).isFalse();
    controls.asking(false);
    assertThat(guide.keepsPointer()).isTrue();
    controls.abort();
    assertThat(guide.keepsPointer()).isFalse();
    assertThat(guide(OperatorViewSettings.DESK).keepsPointer()).isFalse();
  }

  @Test
  void whoHasNoPointerHasKeysInTheParticipantsWindowAndElseInTheOperatorsOnly() {
    guide(OperatorViewSettings.DESK).operatorKey(KeyboardKey.F8, true);
    assertThat(controls.paused()).isFalse();
    guide(OperatorViewSettings.DESK).operatorKey(KeyboardKey.F8, false);
    assertThat(controls.paused()).isTrue();
    guide(IN_A_DISPLAY).operatorKey(KeyboardKey.F8, true);
    assertThat(controls.paused()).isFalse();
    guide(IN_A_DISPLAY).operatorKey(KeyboardKey.F9, true);
    assertThat(controls.takeGoOn()).isTrue();
  }

  @Test
  void aResetOfTheHeadingIsAskedForOnceAndRecorded() throws IOException {
    SceneStepController guide = guide(OperatorViewSettings.DESK);
    controls.resetHeading();
    assertThat(guide.takeHeadingReset()).isTrue();
    assertThat(guide.takeHeadingReset()).isFalse();
    guide.heard(NavigationCommand.RESET_HEADING);
    session.journal().keep("read", Map.of()); // Now all before it is on the disk.
    List<String> events = Files.readAllLines(folder.resolve("sub-001/ses-01/events.jsonl"));
    assertThat(events.get(events.size() - 2))
        .contains("\"event\":\"heading-reset\",\"step\":\"exposure-hall\",\"mono\":");
  }
}
