package org.selectiverenderer.app.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.Container;
import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.FutureTask;
import javax.imageio.ImageIO;
import javax.swing.JButton;
import javax.swing.JFrame;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JToggleButton;
import javax.swing.SwingUtilities;
import javax.swing.text.JTextComponent;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.study.questionnaire.Question;
import org.selectiverenderer.study.questionnaire.Questionnaire;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.testing.WindowFinder;
import org.selectiverenderer.testing.robot.GuiRobot;

/** Pages of questions, answered by keys and by the mouse. */
@ShowsWindows
class QuestionnaireWindowTest extends SessionWindowFixture {
  @Test
  void aQuestionThatAnAnswerBringsHasItsRoom() throws IOException {
    LoadedStudy material = material("en");
    Questionnaire closing =
        material.questionnaires("001").stream()
            .filter(each -> each.id().equals("closing"))
            .findFirst()
            .orElseThrow();
    List<String> heard = new CopyOnWriteArrayList<>();
    FutureTask<Boolean> asked = asking(material, closing, false, heard);
    JFrame window = WindowFinder.named(hands, "questionnaire");
    Question changes = closing.questions().get(1);
    choose(window, changes.text() + ": Yes", heard);
    JTextComponent which = GuiRobot.named(window, "What changed?", JTextComponent.class);
    hands.await("what changed", which::isShowing);
    JScrollPane rows =
        GuiRobot.onEdt(
            () ->
                (JScrollPane)
                    SwingUtilities.getAncestorOfClass(
                        JScrollPane.class,
                        SwingUtilities.getAncestorOfClass(JScrollPane.class, which)));
    assertThat(GuiRobot.onEdt(rows.getVerticalScrollBar()::isShowing)).isFalse();
    String read = GuiRobot.onEdt(() -> texts(window.getContentPane()));
    assertThat(read).as("Enter begins a line").contains("Ctrl+Enter");
    pictures(window, "session-closing");
    over.set(true);
    assertThat(WindowFinder.answer(asked)).isFalse();
  }

  private static String texts(Container in) {
    StringBuilder all = new StringBuilder();
    for (Component each : in.getComponents()) {
      all.append(each instanceof JTextComponent text ? text.getText() + "\n" : "");
      all.append(each instanceof Container more ? texts(more) : "");
    }
    return all.toString();
  }

  @ParameterizedTest
  @ValueSource(strings = {"en", "el"})
  void keysAnswerAPageRowByRow(String language) throws IOException {
    LoadedStudy material = material(language);
    Questionnaire screen = desk(material);
    List<String> heard = new CopyOnWriteArrayList<>();
    FutureTask<Boolean> asked = asking(material, screen, false, heard);
    JFrame window = WindowFinder.named(hands, "questionnaire");
    focus(window);
    List<String> expected = new ArrayList<>();
    for (int row = 0; row < screen.questions().size(); row++) {
      boolean yes = row % 2 == 0;
      int confidence = 1 + row % 5;
      hands.press(yes ? KeyEvent.VK_Y : KeyEvent.VK_N);
      hands.press(KeyEvent.VK_0 + confidence);
      String object = screen.questions().get(row).id();
      expected.add(object + (yes ? " yes" : " no"));
      expected.add(object + (yes ? " yes" : " no") + confidence);
      hands.await("both answers", () -> heard.size() >= expected.size());
      if (row == screen.questions().size() / 2) {
        hands.press(KeyEvent.VK_ENTER);
        assertThat(asked.isDone()).as("Enter while answers are wanting").isFalse();
        pictures(window, "session-questionnaire-" + language);
      }
    }
    hands.press(KeyEvent.VK_ENTER);
    assertThat(WindowFinder.answer(asked)).isTrue();
    assertThat(heard).isEqualTo(expected);
    assertThat(times).allMatch(ms -> ms >= 0);
    assertThat(places.get(places.size() - 1)).isEqualTo(screen.questions().size());
  }

  private static Questionnaire desk(LoadedStudy material) {
    return material.questionnaires("001").stream()
        .filter(each -> each.id().equals("recognition-desk"))
        .findFirst()
        .orElseThrow();
  }

  @Test
  void theMouseAnswersAndChangesAnswersInAnyOrder() throws IOException {
    LoadedStudy material = material("en");
    Questionnaire screen = desk(material);
    Question last = screen.questions().get(screen.questions().size() - 1);
    List<String> heard = new CopyOnWriteArrayList<>();
    FutureTask<Boolean> asked = asking(material, screen, false, heard);
    JFrame window = WindowFinder.named(hands, "questionnaire");
    for (String button : List.of(": Yes", ": 3", ": No")) {
      choose(window, last.text() + button, heard);
    }
    assertThat(heard).containsExactly(last.id() + " yes", last.id() + " yes3", last.id() + " no3");
    assertThat(GuiRobot.onEdt(GuiRobot.named(window, "Continue", JButton.class)::isEnabled))
        .isFalse();
    WindowFinder.close(window);
    hands.await("the question", () -> closings.get() == 1);
    assertThat(asked.isDone()).isFalse();
    over.set(true);
    assertThat(WindowFinder.answer(asked)).isFalse();
  }

  @Test
  void expectancyIsRatedFromOneToSix() throws IOException {
    material("en");
    LoadedStudy pilot =
        LoadedStudy.read(folder.resolve("study/pilot/study.json"), new ProblemCollector())
            .orElseThrow();
    Questionnaire screen = pilot.questionnaires("001").get(1); // The first is the example.
    List<String> heard = new CopyOnWriteArrayList<>();
    FutureTask<Boolean> asked = asking(pilot, screen, false, heard);
    JFrame window = WindowFinder.named(hands, "questionnaire");
    focus(window);
    hands.press(KeyEvent.VK_6);
    hands.press(KeyEvent.VK_7);
    hands.press(KeyEvent.VK_DOWN);
    hands.press(KeyEvent.VK_1);
    hands.await("two answers", () -> heard.size() == 2);
    pictures(window, "session-expectancy");
    assertThat(heard)
        .containsExactly(
            screen.questions().get(0).id() + " 6", screen.questions().get(2).id() + " 1");
    over.set(true);
    assertThat(WindowFinder.answer(asked)).isFalse();
  }

  private LoadedStudy ofKinds(String questionnaire) throws IOException {
    Files.writeString(folder.resolve("all.json"), questionnaire);
    Path file = folder.resolve("kinds.json");
    Files.writeString(
        file,
        """
        {"name": "Kinds", "conditions": ["high"], "participants": 1,
         "questionnaires": [{"file": "all.json"}]}
        """);
    return LoadedStudy.read(file, new ProblemCollector()).orElseThrow();
  }

  @Test
  void allKindsAreAnsweredByKeysPageByPageAndBack() throws IOException {
    LoadedStudy material =
        ofKinds(
            """
            {"name": "all", "title": "All kinds", "pages": [
              {"name": "read", "text": "To be read."},
              {"name": "ask", "questions": [
                {"id": "changes", "kind": "yes-no", "text": "Did anything change?"},
                {"id": "which", "kind": "text", "lines": 2, "text": "What?",
                 "when": {"question": "changes", "is": ["yes"]}},
                {"id": "height", "kind": "number", "min": 50, "max": 250, "unit": "cm",
                 "text": "How tall are you?"},
                {"id": "post", "kind": "single", "text": "What do you do?", "options": [
                  {"value": "ug", "text": "I am an undergraduate student"},
                  {"value": "pg", "text": "I am a postgraduate student of some kind"}]},
                {"id": "seen", "kind": "multiple", "text": "What did you use before?", "options": [
                  {"value": "hmd", "text": "Display"}, {"value": "cave", "text": "CAVE"}]}]},
              {"name": "feel", "questions": [
                {"id": "dark", "kind": "bipolar", "left": "dark", "right": "bright"},
                {"id": "size", "kind": "bipolar", "left": "small", "right": "large"},
                {"id": "more", "kind": "text", "optional": true, "text": "Anything else?"}]}]}
            """);
    List<String> heard = new CopyOnWriteArrayList<>();
    FutureTask<Boolean> asked =
        asking(material, material.questionnaires("001").get(0), false, heard);
    JFrame window = WindowFinder.named(hands, "questionnaire");
    focus(window);
    hands.press(KeyEvent.VK_ENTER);
    hands.await("the second page", () -> pages.size() == 2);
    hands.press(KeyEvent.VK_N);
    hands.await("no", () -> heard.contains("changes no"));
    hands.press(KeyEvent.VK_UP);
    hands.press(KeyEvent.VK_Y);
    hands.await("yes", () -> heard.contains("changes yes"));
    JTextComponent words = named(window, "What?");
    hands.await("the words' field", words::isFocusOwner);
    hands.type("12");
    hands.press(KeyEvent.VK_TAB);
    hands.await("the words", () -> heard.contains("which 12"));
    JTextComponent number = named(window, "How tall are you?");
    hands.await("the number's field", number::isFocusOwner);
    hands.type("17");
    hands.press(KeyEvent.VK_TAB);
    hands.press(KeyEvent.VK_2);
    hands.await("an option", () -> heard.contains("post pg"));
    assertThat(heard).as("17 cm").noneMatch(line -> line.startsWith("height"));
    hands.press(KeyEvent.VK_1);
    hands.press(KeyEvent.VK_2);
    hands.await("both", () -> heard.contains("seen hmd|cave"));
    hands.press(KeyEvent.VK_UP);
    hands.press(KeyEvent.VK_UP);
    hands.await("the number's field again", number::isFocusOwner);
    hands.press(KeyEvent.VK_END);
    hands.type("1");
    hands.await("171 cm", () -> heard.contains("height 171"));
    pictures(window, "session-kinds");
    hands.press(KeyEvent.VK_ENTER);
    hands.await("the third page", () -> pages.size() == 3);
    pictures(window, "session-bipolar");
    hands.press(KeyEvent.VK_5);
    hands.await("bright", () -> heard.contains("dark 5"));
    hands.press(KeyEvent.VK_PAGE_UP);
    hands.await("back", () -> pages.size() == 4);
    hands.press(KeyEvent.VK_ENTER);
    hands.await("on again", () -> pages.size() == 5);
    hands.press(KeyEvent.VK_1);
    hands.await("small", () -> heard.contains("size 1"));
    hands.press(KeyEvent.VK_ENTER);
    assertThat(WindowFinder.answer(asked)).isTrue();
    assertThat(pages).containsExactly("read", "ask", "feel", "ask", "feel");
  }

  private LoadedStudy ofLongScales() throws IOException {
    return ofKinds(
        """
        {"name": "all", "title": "Long scales", "pages": [{"name": "rate", "questions": [
          {"id": "bright", "kind": "scale", "from": 0, "to": 10, "text": "How bright?",
           "least": "dark", "most": "bright"},
          {"id": "warm", "kind": "scale", "from": 0, "to": 10, "text": "How warm?"},
          {"id": "below", "kind": "scale", "from": -10, "to": 0, "text": "How far below?"},
          {"id": "above", "kind": "scale", "from": 10, "to": 20, "text": "How far above?"}]}]}
        """);
  }

  @Test
  void digitsWaitForASecondOneWhereOneCanFollow() throws IOException {
    LoadedStudy material = ofLongScales();
    List<String> heard = new CopyOnWriteArrayList<>();
    FutureTask<Boolean> asked =
        asking(material, material.questionnaires("001").get(0), false, heard);
    JFrame window = WindowFinder.named(hands, "questionnaire");
    focus(window);
    hands.press(KeyEvent.VK_1);
    hands.press(KeyEvent.VK_0);
    hands.await("10", () -> !heard.isEmpty());
    assertThat(heard).containsExactly("bright 10");
    hands.press(KeyEvent.VK_1);
    hands.await("1, when no digit follows", () -> heard.size() == 2);
    hands.press(KeyEvent.VK_MINUS);
    hands.press(KeyEvent.VK_1);
    hands.press(KeyEvent.VK_ENTER);
    hands.await("-1, by Enter", () -> heard.size() == 3);
    hands.press(KeyEvent.VK_1);
    hands.press(KeyEvent.VK_7);
    hands.await("17", () -> heard.size() == 4);
    assertThat(heard).containsExactly("bright 10", "warm 1", "below -1", "above 17");
    pictures(window, "session-long-scales");
    hands.press(KeyEvent.VK_ENTER);
    assertThat(WindowFinder.answer(asked)).isTrue();
  }

  @Test
  void aDigitThatWaitsCountsWhenTheParticipantGoesElsewhere() throws IOException {
    LoadedStudy material = ofLongScales();
    List<String> heard = new CopyOnWriteArrayList<>();
    FutureTask<Boolean> asked =
        asking(material, material.questionnaires("001").get(0), false, heard);
    JFrame window = WindowFinder.named(hands, "questionnaire");
    focus(window);
    hands.press(KeyEvent.VK_1);
    hands.press(KeyEvent.VK_DOWN);
    hands.press(KeyEvent.VK_1);
    hands.press(KeyEvent.VK_5);
    hands.await("both", () -> heard.size() == 2);
    assertThat(heard).as("15 is none").containsExactly("bright 1", "warm 5");
    over.set(true);
    assertThat(WindowFinder.answer(asked)).isFalse();
  }

  @Test
  void buttonsOfNumbersShowTheirWholeText() throws IOException {
    LoadedStudy material = ofLongScales();
    FutureTask<Boolean> asked =
        asking(
            material, material.questionnaires("001").get(0), false, new CopyOnWriteArrayList<>());
    JFrame window = WindowFinder.named(hands, "questionnaire");
    for (String name : List.of("How bright?: 10", "How far below?: -10", "How far above?: 20")) {
      JToggleButton button = GuiRobot.named(window, name, JToggleButton.class);
      assertThat(GuiRobot.onEdt(() -> drawn(button))).isEqualTo(button.getText());
    }
    over.set(true);
    assertThat(WindowFinder.answer(asked)).isFalse();
  }

  @Test
  void slidersAreMovedByKeysAndByTheMouse() throws IOException {
    LoadedStudy material =
        ofKinds(
            """
            {"name": "all", "title": "Lines", "pages": [
              {"name": "read", "text": "To be read."},
              {"name": "rate", "questions": [
                {"id": "like", "kind": "slider", "text": "How much did you like the room?",
                 "least": "not at all", "most": "very much"},
                {"id": "warm", "kind": "slider", "text": "How warm was it?", "from": -1, "to": 1,
                 "step": 0.1, "marks": true, "number": true, "start": 0},
                {"id": "bright", "kind": "scale", "text": "How bright was it?", "from": 0,
                 "to": 100, "least": "dark", "most": "bright"}]}]}
            """);
    List<String> heard = new CopyOnWriteArrayList<>();
    FutureTask<Boolean> asked =
        asking(material, material.questionnaires("001").get(0), false, heard);
    JFrame window = WindowFinder.named(hands, "questionnaire");
    focus(window);
    hands.press(KeyEvent.VK_ENTER);
    hands.await("the second page", () -> pages.size() == 2);
    pictures(window, "session-sliders-open");
    hands.press(KeyEvent.VK_RIGHT);
    hands.press(KeyEvent.VK_RIGHT);
    hands.press(KeyEvent.VK_PAGE_UP);
    hands.await("61, when the keys rest", () -> heard.contains("like 61"));
    hands.press(KeyEvent.VK_END);
    hands.press(KeyEvent.VK_LEFT);
    hands.press(KeyEvent.VK_DOWN);
    hands.await("99, when one goes on", () -> heard.contains("like 99"));
    hands.press(KeyEvent.VK_ENTER);
    assertThat(asked.isDone()).as("the thumb that is shown is no answer").isFalse();
    hands.press(KeyEvent.VK_SPACE);
    hands.await("0, taken as it is", () -> heard.contains("warm 0"));
    hands.press(KeyEvent.VK_DOWN);
    hands.press(KeyEvent.VK_7);
    hands.press(KeyEvent.VK_5);
    hands.await("75", () -> heard.contains("bright 75"));
    hands.press(KeyEvent.VK_1);
    hands.press(KeyEvent.VK_0);
    hands.press(KeyEvent.VK_0);
    hands.await("100", () -> heard.contains("bright 100"));
    SliderTrack line = GuiRobot.named(window, "How warm was it?", SliderTrack.class);
    hands.click(line);
    hands.await("the middle, by the mouse", () -> heard.size() == 6);
    pictures(window, "session-sliders");
    assertThat(heard)
        .containsExactly("like 61", "like 99", "warm 0", "bright 75", "bright 100", "warm 0");
    hands.press(KeyEvent.VK_HOME);
    hands.press(KeyEvent.VK_ENTER);
    assertThat(WindowFinder.answer(asked)).isTrue();
    assertThat(heard).last().isEqualTo("warm -1");
    assertThat(times).allMatch(ms -> ms >= 0);
  }

  @Test
  void optionsAreRankedByKeysAndByDragging() throws IOException {
    LoadedStudy material =
        ofKinds(
            """
            {"name": "all", "title": "Orders", "pages": [{"name": "rank", "questions": [
              {"id": "best", "kind": "ranking", "text": "Which room did you like best?", "options": [
                {"value": "hall", "text": "The hall"}, {"value": "attic", "text": "The attic"},
                {"value": "cellar", "text": "The cellar"}]},
              {"id": "agree", "kind": "grid", "text": "How far do you agree?", "options": [
                {"value": "1", "text": "I do not agree at all"},
                {"value": "2", "text": "I neither agree nor disagree"},
                {"value": "3", "text": "I agree completely"}], "rows": [
                {"id": "warm", "text": "The rooms were warm."},
                {"id": "large", "text": "The rooms were larger than those in which I live."}]}]}]}
            """);
    List<String> heard = new CopyOnWriteArrayList<>();
    FutureTask<Boolean> asked =
        asking(material, material.questionnaires("001").get(0), false, heard);
    JFrame window = WindowFinder.named(hands, "questionnaire");
    focus(window);
    hands.press(KeyEvent.VK_SPACE);
    hands.await("the order as it is", () -> heard.contains("best hall|attic|cellar"));
    hands.press(KeyEvent.VK_3);
    hands.await("the hall last", () -> heard.contains("best attic|cellar|hall"));
    hands.press(KeyEvent.VK_UP);
    hands.press(KeyEvent.VK_SHIFT, KeyEvent.VK_UP);
    hands.await("the cellar first", () -> heard.contains("best cellar|attic|hall"));
    JPanel hall = GuiRobot.named(window, "Which room did you like best?: The hall", JPanel.class);
    hands.drag(hall, 0.5, 0.5, 0.5, -1.5);
    hands.await("the hall first", () -> heard.contains("best hall|cellar|attic"));
    hands.press(KeyEvent.VK_TAB);
    hands.press(KeyEvent.VK_3);
    hands.await("the first row", () -> heard.contains("agree_warm 3"));
    hands.press(KeyEvent.VK_1);
    hands.await("the second row", () -> heard.contains("agree_large 1"));
    pictures(window, "session-orders");
    assertThat(texts(window.getContentPane())).contains("How far do you agree?");
    hands.press(KeyEvent.VK_ENTER);
    assertThat(WindowFinder.answer(asked)).isTrue();
  }

  @Test
  void picturesAreChosenByKeysAndByTheMouse() throws IOException {
    for (String name : List.of("hall.png", "attic.png", "cellar.png")) {
      BufferedImage picture = new BufferedImage(400, 300, BufferedImage.TYPE_INT_RGB);
      picture.setRGB(200, 150, name.hashCode());
      ImageIO.write(picture, "png", folder.resolve(name).toFile());
    }
    LoadedStudy material =
        ofKinds(
            """
            {"name": "all", "title": "Pictures", "pages": [{"name": "see", "questions": [
              {"id": "room", "kind": "single", "text": "Where were you?", "options": [
                {"value": "hall", "text": "The hall", "picture": "hall.png"},
                {"value": "attic", "text": "The attic", "picture": "attic.png"}]},
              {"id": "seen", "kind": "multiple", "text": "What have you seen?", "options": [
                {"value": "hall", "text": "The hall", "picture": "hall.png"},
                {"value": "attic", "text": "The attic", "picture": "attic.png"},
                {"value": "cellar", "text": "The cellar", "picture": "cellar.png"}]}]}]}
            """);
    List<String> heard = new CopyOnWriteArrayList<>();
    FutureTask<Boolean> asked =
        asking(material, material.questionnaires("001").get(0), false, heard);
    JFrame window = WindowFinder.named(hands, "questionnaire");
    focus(window);
    hands.press(KeyEvent.VK_2);
    hands.await("the attic", () -> heard.contains("room attic"));
    hands.press(KeyEvent.VK_3);
    hands.await("the cellar", () -> heard.contains("seen cellar"));
    choose(window, "What have you seen?: The hall", heard);
    assertThat(heard).containsExactly("room attic", "seen cellar", "seen hall|cellar");
    pictures(window, "session-pictures");
    hands.press(KeyEvent.VK_ENTER);
    assertThat(WindowFinder.answer(asked)).isTrue();
  }

  /** Returns the text that a button has room for: with dots at its end if it is cut. */
  private static String drawn(JToggleButton button) {
    return SwingUtilities.layoutCompoundLabel(
        button,
        button.getFontMetrics(button.getFont()),
        button.getText(),
        null,
        button.getVerticalAlignment(),
        button.getHorizontalAlignment(),
        button.getVerticalTextPosition(),
        button.getHorizontalTextPosition(),
        SwingUtilities.calculateInnerArea(button, new Rectangle()),
        new Rectangle(),
        new Rectangle(),
        button.getIconTextGap());
  }

  private static JTextComponent named(JFrame window, String name) {
    return GuiRobot.named(window, name, JTextComponent.class);
  }
}
