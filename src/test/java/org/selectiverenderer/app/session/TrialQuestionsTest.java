package org.selectiverenderer.app.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.browser.camera.Primitive2D;
import org.selectiverenderer.render.window.KeyboardKey;
import org.selectiverenderer.study.design.BlockProgress;
import org.selectiverenderer.study.questionnaire.Answer;
import org.selectiverenderer.study.session.Session;
import org.selectiverenderer.study.session.SessionStep;

/** Questions in the picture of a trial, answered by keys. */
class TrialQuestionsTest {
  @TempDir private Path folder;
  private Session session;
  private SessionStep.OneTrial trial;

  private TrialQuestions asked(String questions) throws IOException {
    Files.writeString(
        folder.resolve("rooms.x3d"),
        "<X3D version='4.0' profile='Immersive'><Scene>"
            + "<Viewpoint DEF='Here' position='0 1.6 0'/></Scene></X3D>");
    Files.writeString(
        folder.resolve("rate.json"),
        "{\"name\": \"rate\", \"pages\": [{\"questions\": [%s]}]}".formatted(questions));
    Path study =
        Files.writeString(
            folder.resolve("study.json"),
            """
            {"name": "Rooms", "participants": 1, "scene": "rooms.x3d",
             "factors": [{"name": "light", "varies": "within", "levels": [
               {"name": "on", "light": "on"}, {"name": "off", "light": "off"}]}],
             "blocks": [{"name": "main", "viewpoint": "Here", "trial": [
               {"show": "exposure", "seconds": 1},
               {"show": "questions", "questionnaire": "rate"}]}],
             "questionnaires": [{"file": "rate.json", "when": "in-trials", "name": "rate"}]}
            """);
    session = StartedSession.of(study);
    SessionStep.Block block =
        session.remaining().stream()
            .filter(SessionStep.Block.class::isInstance)
            .map(SessionStep.Block.class::cast)
            .findFirst()
            .orElseThrow();
    BlockProgress progress = session.progress(block);
    trial = new SessionStep.OneTrial(progress.next().orElseThrow());
    session.began(trial, progress);
    return of(AnswerDevice.KEYBOARD);
  }

  private TrialQuestions of(AnswerDevice device) throws IOException {
    return new TrialQuestions(
        session, trial, session.material().inTrials("rate").orElseThrow(), device);
  }

  @AfterEach
  void end() throws IOException {
    session.close();
  }

  private static void type(TrialQuestions asked, String text) {
    for (String character : text.split("")) {
      asked.pressed(KeyboardKey.OTHER, character);
    }
  }

  private static List<String> texts(TrialQuestions asked) {
    return asked.sheet().marks().stream()
        .filter(Primitive2D.Text.class::isInstance)
        .map(mark -> ((Primitive2D.Text) mark).text())
        .toList();
  }

  private Map<String, Answer> answers() {
    return session.answers(trial);
  }

  @Test
  void theLastLineExplainsTheDeviceThatIsThere() throws IOException {
    TrialQuestions keys = asked("{\"id\": \"far\", \"kind\": \"slider\", \"text\": \"How far?\"}");
    assertThat(String.join(" ", texts(keys)))
        .contains("Enter gives the answer")
        .doesNotContain("button");
    assertThat(String.join(" ", texts(of(AnswerDevice.BUTTONS)))).contains("button");
  }

  @Test
  void aSliderIsMovedByKeysAndGivenByEnter() throws IOException {
    TrialQuestions asked =
        asked(
            """
            {"id": "far", "kind": "slider", "text": "How far?", "least": "near", "most": "away"},
            {"id": "bright", "kind": "scale", "text": "How bright?", "from": 0, "to": 100}
            """);
    assertThat(texts(asked)).contains("How far?", "near", "away");
    int before = asked.sheet().marks().size();
    asked.pressed(KeyboardKey.ENTER, "");
    asked.pressed(KeyboardKey.RIGHT, "");
    assertThat(asked.sheet().marks()).as("the thumb is there now").hasSize(before + 1);
    asked.pressed(KeyboardKey.PAGE_UP, "");
    asked.pressed(KeyboardKey.LEFT, "");
    type(asked, "3"); // No number is shown, so none can be typed.
    asked.pressed(KeyboardKey.SPACE, " ");
    type(asked, "100");
    assertThat(texts(asked)).contains("How bright?", "100");
    assertThat(asked.over()).as("the number may still change").isFalse();
    asked.pressed(KeyboardKey.END, "");
    asked.pressed(KeyboardKey.PAGE_DOWN, "");
    asked.pressed(KeyboardKey.ENTER, "");
    asked.pressed(KeyboardKey.ENTER, "");
    assertThat(asked.over()).isTrue();
    assertThat(answers())
        .containsOnly(Map.entry("far", Answer.of("59")), Map.entry("bright", Answer.of("90")));
  }

  @Test
  void aDigitWaitsForASecondOneWhereOneCanFollow() throws IOException {
    TrialQuestions asked =
        asked(
            """
            {"id": "warm", "kind": "scale", "text": "How warm?", "from": 0, "to": 10},
            {"id": "cold", "kind": "scale", "text": "How cold?", "from": 0, "to": 10}
            """);
    type(asked, "10");
    type(asked, "1");
    asked.pressed(KeyboardKey.ENTER, "");
    asked.pressed(KeyboardKey.ENTER, "");
    assertThat(asked.over()).isTrue();
    assertThat(answers())
        .containsOnly(Map.entry("warm", Answer.of("10")), Map.entry("cold", Answer.of("1")));
  }

  @Test
  void aNumberIsTypedBesideItsUnit() throws IOException {
    TrialQuestions asked =
        asked(
            """
            {"id": "height", "kind": "number", "text": "How high is the room?", "min": 1, "max": 9,
             "unit": "m"}
            """);
    assertThat(texts(asked)).contains("1 \u2013 9 m");
    type(asked, "27");
    asked.pressed(KeyboardKey.ENTER, "");
    assertThat(texts(asked)).as("27 is above 9").contains("27_");
    asked.pressed(KeyboardKey.BACKSPACE, "");
    type(asked, ",5");
    asked.pressed(KeyboardKey.ENTER, "");
    asked.pressed(KeyboardKey.ENTER, "");
    assertThat(asked.over()).isTrue();
    assertThat(answers()).containsOnly(Map.entry("height", Answer.of("2.5")));
  }

  @Test
  void aRankingAndAGridAreAskedOneByOne() throws IOException {
    TrialQuestions asked =
        asked(
            """
            {"id": "best", "kind": "ranking", "text": "Which first?", "options": [
              {"value": "red", "text": "Red"}, {"value": "blue", "text": "Blue"}]},
            {"id": "agree", "kind": "grid", "text": "Do you agree?", "options": [
              {"value": "1", "text": "no"}, {"value": "2", "text": "a little"},
              {"value": "3", "text": "yes"}], "rows": [
              {"id": "warm", "text": "It was warm."}, {"id": "large", "text": "It was large."}]}
            """);
    asked.pressed(KeyboardKey.DOWN, "");
    asked.pressed(KeyboardKey.DOWN, "");
    asked.pressed(KeyboardKey.ENTER, "");
    assertThat(texts(asked)).contains("1. Blue", "Red");
    type(asked, "r");
    asked.pressed(KeyboardKey.ENTER, "");
    assertThat(texts(asked)).contains("Do you agree?", "It was warm.", "a little");
    type(asked, "2");
    assertThat(texts(asked)).contains("Do you agree?", "It was large.");
    type(asked, "3");
    asked.pressed(KeyboardKey.ENTER, "");
    assertThat(asked.over()).isTrue();
    assertThat(answers())
        .containsOnly(
            Map.entry("best", Answer.of("blue|red")),
            Map.entry("agree_warm", Answer.of("2")),
            Map.entry("agree_large", Answer.of("3")));
  }

  @Test
  void optionsMayBePictures() throws IOException {
    for (String name : List.of("a.png", "b.png")) {
      ImageIO.write(
          new BufferedImage(800, 400, BufferedImage.TYPE_INT_RGB),
          "png",
          folder.resolve(name).toFile());
    }
    TrialQuestions asked =
        asked(
            """
            {"id": "room", "kind": "single", "text": "Where were you?", "options": [
              {"value": "a", "text": "in the hall", "picture": "a.png"},
              {"value": "b", "text": "in the attic", "picture": "b.png"}]}
            """);
    List<Primitive2D.Picture> drawn =
        asked.sheet().marks().stream()
            .filter(Primitive2D.Picture.class::isInstance)
            .map(Primitive2D.Picture.class::cast)
            .toList();
    assertThat(drawn).hasSize(2);
    assertThat(drawn.get(0).pixels().width()).isEqualTo(384); // As many as a panel shows.
    assertThat(drawn.get(0).width()).isEqualTo(2 * drawn.get(0).height());
    assertThat(texts(asked)).doesNotContain("in the hall");
    type(asked, "2");
    asked.pressed(KeyboardKey.ENTER, "");
    assertThat(asked.over()).isTrue();
    assertThat(answers()).containsOnly(Map.entry("room", Answer.of("b")));
  }
}
