package org.selectiverenderer.app.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
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
