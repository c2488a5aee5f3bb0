package org.selectiverenderer.app.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import javax.swing.JFrame;
import javax.swing.JToggleButton;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.study.definition.StudyTemplate;
import org.selectiverenderer.study.questionnaire.Questionnaire;
import org.selectiverenderer.study.session.ExperimenterControls;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.session.Session;
import org.selectiverenderer.study.session.SessionOptions;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.testing.WindowFinder;
import org.selectiverenderer.testing.robot.DisplaySettling;
import org.selectiverenderer.testing.robot.GuiRobot;

/**
 * Pictures of a session's windows with the template's study, for the manual: {@code
 * docs/pictures.sh} runs this at 200 %, so that letters are as wide as their windows think.
 */
@ShowsWindows
@EnabledIfSystemProperty(named = "sun.java2d.uiScale", matches = "2")
@Timeout(value = 180, unit = TimeUnit.SECONDS)
class SessionPictures extends SessionWindowFixture {
  private static final int SCALE = 2;

  private LoadedStudy template() throws IOException {
    Path file = StudyTemplate.write(folder.resolve("study"), Path.of("scenes/apartment.x3d"));
    return LoadedStudy.read(file, new ProblemCollector()).orElseThrow();
  }

  private static Questionnaire asked(LoadedStudy material, String id) {
    return Stream.concat(Stream.of(material.form()), material.questionnaires("001").stream())
        .filter(each -> each.id().equals(id))
        .findFirst()
        .orElseThrow(
            () ->
                new AssertionError(
                    material.questionnaires("001").stream().map(Questionnaire::id).toList()));
  }

  @ParameterizedTest
  @CsvSource({
    "session-consent, form, ''",
    "session-questionnaire, recognition-desk, ''",
    "session-bipolar, room, ''",
    "session-kinds, closing, : Yes"
  })
  void questions(String name, String questionnaire, String answer) throws IOException {
    LoadedStudy material = template();
    Questionnaire shown = asked(material, questionnaire);
    List<String> heard = new CopyOnWriteArrayList<>();
    asking(material, shown, questionnaire.equals("form"), heard);
    JFrame window = WindowFinder.named(hands, "questionnaire");
    if (!answer.isEmpty()) {
      choose(window, shown.questions().get(1).text() + answer, heard);
      DisplaySettling.pause(500);
    }
    assertThat(pages).isNotEmpty();
    GuiRobot.picture(window.getContentPane(), name, SCALE);
  }

  /** Takes a picture of a questionnaire's only page after some keys. */
  private void own(String name, String questions, int... keys) throws IOException {
    Files.writeString(
        folder.resolve("own.json"),
        "{\"name\": \"own\", \"title\": \"The room\", \"pages\": [{\"questions\": [%s]}]}"
            .formatted(questions));
    Path file =
        Files.writeString(
            folder.resolve("own-study.json"),
            """
            {"name": "Own", "conditions": ["high"], "participants": 1,
             "questionnaires": [{"file": "own.json"}]}
            """);
    LoadedStudy material = LoadedStudy.read(file, new ProblemCollector()).orElseThrow();
    List<String> heard = new CopyOnWriteArrayList<>();
    asking(material, material.questionnaires("001").get(0), false, heard);
    JFrame window = WindowFinder.named(hands, "questionnaire");
    focus(window);
    for (int key : keys) {
      hands.press(key);
    }
    DisplaySettling.pause(1000);
    assertThat(heard).isNotEmpty();
    GuiRobot.picture(window.getContentPane(), name, SCALE);
  }

  @Test
  void sliders() throws IOException {
    own(
        "session-sliders",
        """
        {"id": "like", "kind": "slider", "text": "How much did you like the room?",
         "least": "not at all", "most": "very much"},
        {"id": "warm", "kind": "slider", "text": "How warm did it look?", "from": -1, "to": 1,
         "step": 0.1, "marks": true, "number": true, "start": 0, "least": "cold", "most": "hot"},
        {"id": "bright", "kind": "scale", "text": "How bright was it?", "from": 0, "to": 100,
         "least": "dark", "most": "bright"}
        """,
        KeyEvent.VK_RIGHT,
        KeyEvent.VK_PAGE_UP,
        KeyEvent.VK_PAGE_UP,
        KeyEvent.VK_DOWN,
        KeyEvent.VK_DOWN,
        KeyEvent.VK_3,
        KeyEvent.VK_5);
  }

  @Test
  void orders() throws IOException {
    own(
        "session-orders",
        """
        {"id": "best", "kind": "ranking", "text": "Which room did you like best?", "options": [
          {"value": "kitchen", "text": "The kitchen"}, {"value": "lounge", "text": "The lounge"},
          {"value": "office", "text": "The office"}]},
        {"id": "agree", "kind": "grid", "text": "How far do you agree?", "options": [
          {"value": "1", "text": "not at all"}, {"value": "2", "text": "rather not"},
          {"value": "3", "text": "neither"}, {"value": "4", "text": "rather"},
          {"value": "5", "text": "fully"}], "rows": [
          {"id": "warm", "text": "The rooms were warm."},
          {"id": "large", "text": "The rooms were larger than those in which I live."},
          {"id": "live", "text": "I would like to live there."}]}
        """,
        KeyEvent.VK_2,
        KeyEvent.VK_TAB,
        KeyEvent.VK_4,
        KeyEvent.VK_2);
  }

  @Test
  void controls() throws IOException {
    try (Session session =
        Session.begin(
            template(),
            "001",
            1,
            new SessionOptions(Optional.empty(), OptionalDouble.empty(), false, "test"),
            new ProblemCollector())) {
      ExperimenterControls controls = new ExperimenterControls(session.journal());
      ControlWindow opened = ControlWindow.open(controls, MonitorBounds.USUAL);
      try {
        JFrame window = WindowFinder.named(hands, "controls");
        controls.status("exposure-kitchen: 20 s left");
        JToggleButton pause = GuiRobot.named(window, "Pause (F8)", JToggleButton.class);
        DisplaySettling.pause(1000);
        assertThat(GuiRobot.onEdt(pause::isShowing)).isTrue();
        GuiRobot.picture(window.getContentPane(), "session-controls", SCALE);
      } finally {
        opened.close();
      }
      session.abort("form");
    }
  }
}
