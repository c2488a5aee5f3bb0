package org.selectiverenderer.app.window;

import static org.assertj.core.api.Assertions.assertThat;

import com.formdev.flatlaf.FlatLightLaf;
import java.awt.Rectangle;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.FutureTask;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Collectors;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JToggleButton;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.app.narration.SilentNarration;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.study.definition.StudyTemplate;
import org.selectiverenderer.study.questionnaire.Answer;
import org.selectiverenderer.study.questionnaire.Question;
import org.selectiverenderer.study.questionnaire.Questionnaire;
import org.selectiverenderer.study.questionnaire.QuestionnairePage;
import org.selectiverenderer.study.questionnaire.QuestionnaireProgress;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.testing.RequiresDisplay;
import org.selectiverenderer.testing.WindowFinder;
import org.selectiverenderer.testing.robot.GuiRobot;

/** Studies whose windows are driven as people drive them, and what was heard of the answers. */
@RequiresDisplay
abstract class SessionWindowFixture {
  @TempDir Path folder;
  private static final int FEW_ROWS = 8;

  final GuiRobot hands = new GuiRobot();
  final AtomicBoolean over = new AtomicBoolean();
  final List<String> pages = new CopyOnWriteArrayList<>();
  final List<Integer> places = new CopyOnWriteArrayList<>();
  final List<Long> times = new CopyOnWriteArrayList<>();
  final MonitorBounds desk = MonitorBounds.USUAL;
  final AtomicInteger closings = new AtomicInteger();
  final SessionEndWatcher end = new SessionEndWatcher(over::get, closings::incrementAndGet);

  @BeforeEach
  void look() {
    WindowFinder.closeAll();
    GuiRobot.onEdt(FlatLightLaf::setup);
  }

  @AfterEach
  void closeAll() {
    over.set(true);
    WindowFinder.closeAll();
  }

  LoadedStudy material(String language) throws IOException {
    Path file = StudyTemplate.write(folder.resolve("study"), Path.of("scenes/apartment.x3d"));
    Files.writeString(
        file,
        Files.readString(file)
            .replace("\"language\": \"en\"", "\"language\": \"" + language + "\""));
    shorten(file.resolveSibling("recognition.csv"), "desk,");
    shorten(file.resolveSibling("pilot/expectancy.csv"), "kitchen,");
    return LoadedStudy.read(file, new ProblemCollector()).orElseThrow();
  }

  /** Leaves few rows of a long list: each costs a robot's second. */
  private static void shorten(Path items, String list) throws IOException {
    int[] rows = {0};
    Files.writeString(
        items,
        Files.readString(items)
            .lines()
            .filter(line -> !line.startsWith(list) || rows[0]++ < FEW_ROWS)
            .map(line -> line + "\n")
            .collect(Collectors.joining()));
    assertThat(rows[0]).isGreaterThan(FEW_ROWS);
  }

  /** A study without a form of its own. */
  LoadedStudy form(String language) throws IOException {
    Path file = folder.resolve("plain.json");
    Files.writeString(
        folder.resolve("i.csv"),
        "area,object,consistency,present,en,el\nhall,coat,consistent,yes,Coat,Παλτό\n");
    Files.writeString(
        file,
        """
        {"name": "Plain", "conditions": ["high"], "participants": 1, "language": "%s",
         "questionnaires": [{"kind": "recognition", "items": "i.csv"}]}
        """
            .formatted(language));
    return LoadedStudy.read(file, new ProblemCollector()).orElseThrow();
  }

  static void pictures(JFrame frame, String name) {
    GuiRobot.picture(frame.getContentPane(), name, 1);
    GuiRobot.picture(frame.getContentPane(), name + "-200", 2);
  }

  FutureTask<Boolean> asking(
      LoadedStudy material, Questionnaire asked, boolean mayRefuse, List<String> heard) {
    return WindowFinder.asking(
        () ->
            QuestionnaireWindow.ask(
                new QuestionnaireWindow.Asking(
                    asked, material.wording(), "007", Map.of(), Optional.empty(), mayRefuse),
                new QuestionnaireProgress.Listener() {
                  @Override
                  public void shown(QuestionnairePage page, List<Question> questions) {
                    pages.add(page.id());
                  }

                  @Override
                  public void answered(Question question, Answer answer, long ms, int place) {
                    heard.add(
                        question.id()
                            + " "
                            + answer.value()
                            + (answer.confidence() > 0 ? answer.confidence() : ""));
                    places.add(place);
                    times.add(ms);
                  }
                },
                end,
                desk,
                Optional.of(SilentNarration.make())));
  }

  void choose(JFrame window, String name, List<String> heard) {
    int before = heard.size();
    JToggleButton button = GuiRobot.named(window, name, JToggleButton.class);
    GuiRobot.onEdt(
        () -> {
          button.scrollRectToVisible(new Rectangle(button.getSize()));
          return true;
        });
    WindowFinder.click(hands, button, () -> heard.size() > before);
  }

  void focus(JFrame window) {
    JLabel title = GuiRobot.named(window, window.getTitle(), JLabel.class);
    hands.click(title);
    WindowFinder.click(hands, title, window::isFocused);
  }
}
