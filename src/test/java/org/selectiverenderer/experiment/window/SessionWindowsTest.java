package org.selectiverenderer.experiment.window;

import static org.assertj.core.api.Assertions.assertThat;

import com.formdev.flatlaf.FlatLightLaf;
import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Container;
import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.FutureTask;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Collectors;
import javax.swing.JButton;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JScrollPane;
import javax.swing.JTextField;
import javax.swing.JToggleButton;
import javax.swing.SwingUtilities;
import javax.swing.text.JTextComponent;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.enricher.driving.Hands;
import org.selectiverenderer.experiment.questionnaire.Answer;
import org.selectiverenderer.experiment.questionnaire.Page;
import org.selectiverenderer.experiment.questionnaire.Question;
import org.selectiverenderer.experiment.questionnaire.Questionnaire;
import org.selectiverenderer.experiment.questionnaire.Wording;
import org.selectiverenderer.experiment.session.OperatorControls;
import org.selectiverenderer.experiment.session.Session;
import org.selectiverenderer.experiment.session.SessionOptions;
import org.selectiverenderer.experiment.session.StudyMaterial;
import org.selectiverenderer.experiment.study.StudyTemplate;
import org.selectiverenderer.testing.OpenWindow;
import org.selectiverenderer.testing.RequiresDisplay;

@RequiresDisplay
class SessionWindowsTest {
  @TempDir Path folder;
  private static final int FEW_ROWS = 8;

  private final Hands hands = new Hands();
  private final AtomicBoolean over = new AtomicBoolean();
  private final List<String> pages = new CopyOnWriteArrayList<>();
  private final List<Integer> places = new CopyOnWriteArrayList<>();
  private final List<Long> times = new CopyOnWriteArrayList<>();
  private final DesktopPlace desk = DesktopPlace.USUAL;
  private final AtomicInteger closings = new AtomicInteger();
  private final SessionEnd end = new SessionEnd(over::get, closings::incrementAndGet);

  @BeforeEach
  void look() {
    OpenWindow.closeAll();
    Hands.onEdt(FlatLightLaf::setup);
  }

  @AfterEach
  void closeAll() {
    over.set(true);
    OpenWindow.closeAll();
  }

  private StudyMaterial material(String language) throws IOException {
    Path file = StudyTemplate.write(folder.resolve("study"), Path.of("scenes/apartment.x3d"));
    Files.writeString(
        file,
        Files.readString(file)
            .replace("\"language\": \"en\"", "\"language\": \"" + language + "\""));
    shorten(file.resolveSibling("recognition.csv"), "desk,");
    shorten(file.resolveSibling("pilot/expectancy.csv"), "kitchen,");
    return StudyMaterial.read(file, new Problems()).orElseThrow();
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
  private StudyMaterial form(String language) throws IOException {
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
    return StudyMaterial.read(file, new Problems()).orElseThrow();
  }

  private static void pictures(JFrame frame, String name) {
    Hands.picture(frame.getContentPane(), name, 1);
    Hands.picture(frame.getContentPane(), name + "-200", 2);
  }

  private FutureTask<Boolean> asking(
      StudyMaterial material, Questionnaire asked, boolean mayRefuse, List<String> heard) {
    return OpenWindow.asking(
        () ->
            QuestionnaireWindow.ask(
                new QuestionnaireWindow.Asking(
                    asked, material.wording(), "007", Map.of(), Optional.empty(), mayRefuse),
                new QuestionnaireWindow.Listener() {
                  @Override
                  public void shown(Page page, List<Question> questions) {
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
                desk));
  }

  @Test
  void windowsArePutIntoTheMiddleOfTheMonitorThatIsNotBeforeAnEye() {
    // As beside an eye's monitor of 290 pixels.
    DesktopPlace beside = new DesktopPlace(0, 290, 0, 990, 700);
    Rectangle window =
        Hands.onEdt(
            () -> {
              JFrame frame = new JFrame(beside.configuration());
              frame.setSize(500, 300);
              beside.center(frame);
              Rectangle bounds = frame.getBounds();
              frame.dispose();
              return bounds;
            });
    assertThat(window).isEqualTo(new Rectangle(535, 200, 500, 300));
  }

  private void choose(JFrame window, String name, List<String> heard) {
    int before = heard.size();
    JToggleButton button = Hands.named(window, name, JToggleButton.class);
    Hands.onEdt(
        () -> {
          button.scrollRectToVisible(new Rectangle(button.getSize()));
          return true;
        });
    OpenWindow.click(hands, button, () -> heard.size() > before);
  }

  private void focus(JFrame window) {
    JLabel title = Hands.named(window, window.getTitle(), JLabel.class);
    hands.click(title);
    OpenWindow.click(hands, title, window::isFocused);
  }

  @Test
  void theFormGoesOnWithAnAgeAndConsentOnly() throws IOException {
    StudyMaterial material = form("en");
    List<String> heard = new CopyOnWriteArrayList<>();
    FutureTask<Boolean> asked = asking(material, material.form(), true, heard);
    JFrame form = OpenWindow.named(hands, "questionnaire");
    JButton begin = Hands.named(form, "Begin", JButton.class);
    choose(form, "Age: 28-32", heard);
    assertThat(Hands.onEdt(begin::isEnabled)).isFalse();
    String consent = material.form().questions().get(0).text();
    choose(form, consent + ": No", heard);
    assertThat(Hands.onEdt(begin::isEnabled)).as("who does not consent").isFalse();
    pictures(form, "session-form-refused");
    choose(form, consent + ": Yes", heard);
    hands.await("Begin", begin::isEnabled);
    pictures(form, "session-form");
    OpenWindow.click(hands, begin, () -> !form.isShowing());
    assertThat(OpenWindow.answer(asked)).isTrue();
    assertThat(heard).containsExactly("age 28-32", "consent no", "consent yes");
    assertThat(places).containsExactly(2, 1, 1);
  }

  @Test
  void theFormSaysWhoDoesNotTakePart() throws IOException {
    StudyMaterial material = form("el");
    FutureTask<Boolean> asked = asking(material, material.form(), true, new ArrayList<>());
    JFrame form = OpenWindow.named(hands, "questionnaire");
    pictures(form, "session-form-greek");
    JButton cancel = Hands.named(form, material.wording().of("form.cancel"), JButton.class);
    OpenWindow.click(hands, cancel, () -> !form.isShowing());
    assertThat(OpenWindow.answer(asked)).isFalse();
  }

  @Test
  void aQuestionThatAnAnswerBringsHasItsRoom() throws IOException {
    StudyMaterial material = material("en");
    Questionnaire closing =
        material.questionnaires("001").stream()
            .filter(each -> each.id().equals("closing"))
            .findFirst()
            .orElseThrow();
    List<String> heard = new CopyOnWriteArrayList<>();
    FutureTask<Boolean> asked = asking(material, closing, false, heard);
    JFrame window = OpenWindow.named(hands, "questionnaire");
    Question changes = closing.questions().get(1);
    choose(window, changes.text() + ": Yes", heard);
    JTextComponent which = Hands.named(window, "What changed?", JTextComponent.class);
    hands.await("what changed", which::isShowing);
    JScrollPane rows =
        Hands.onEdt(
            () ->
                (JScrollPane)
                    SwingUtilities.getAncestorOfClass(
                        JScrollPane.class,
                        SwingUtilities.getAncestorOfClass(JScrollPane.class, which)));
    assertThat(Hands.onEdt(rows.getVerticalScrollBar()::isShowing)).isFalse();
    String read = Hands.onEdt(() -> texts(window.getContentPane()));
    assertThat(read).as("Enter begins a line").contains("Ctrl+Enter");
    pictures(window, "session-closing");
    over.set(true);
    assertThat(OpenWindow.answer(asked)).isFalse();
  }

  private static String texts(Container in) {
    StringBuilder all = new StringBuilder();
    for (Component each : in.getComponents()) {
      all.append(each instanceof JTextComponent text ? text.getText() + "\n" : "");
      all.append(each instanceof Container more ? texts(more) : "");
    }
    return all.toString();
  }

  @Test
  void closingTheFormAsksAndTheFormGoesWithTheSessionOnly() throws IOException {
    StudyMaterial material = form("en");
    FutureTask<Boolean> asked = asking(material, material.form(), true, new ArrayList<>());
    JFrame form = OpenWindow.named(hands, "questionnaire");
    OpenWindow.close(form);
    hands.await("the question", () -> closings.get() == 1);
    assertThat(Hands.onEdt(form::isShowing)).isTrue();
    assertThat(asked.isDone()).isFalse();
    over.set(true);
    assertThat(OpenWindow.answer(asked)).isFalse();
    hands.await("the form to go", () -> !form.isShowing());
  }

  @ParameterizedTest
  @ValueSource(strings = {"en", "el"})
  void keysAnswerAPageRowByRow(String language) throws IOException {
    StudyMaterial material = material(language);
    Questionnaire screen = desk(material);
    List<String> heard = new CopyOnWriteArrayList<>();
    FutureTask<Boolean> asked = asking(material, screen, false, heard);
    JFrame window = OpenWindow.named(hands, "questionnaire");
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
    assertThat(OpenWindow.answer(asked)).isTrue();
    assertThat(heard).isEqualTo(expected);
    assertThat(times).allMatch(ms -> ms >= 0);
    assertThat(places.get(places.size() - 1)).isEqualTo(screen.questions().size());
  }

  private static Questionnaire desk(StudyMaterial material) {
    return material.questionnaires("001").stream()
        .filter(each -> each.id().equals("recognition-desk"))
        .findFirst()
        .orElseThrow();
  }

  @Test
  void theMouseAnswersAndChangesAnswersInAnyOrder() throws IOException {
    StudyMaterial material = material("en");
    Questionnaire screen = desk(material);
    Question last = screen.questions().get(screen.questions().size() - 1);
    List<String> heard = new CopyOnWriteArrayList<>();
    FutureTask<Boolean> asked = asking(material, screen, false, heard);
    JFrame window = OpenWindow.named(hands, "questionnaire");
    for (String button : List.of(": Yes", ": 3", ": No")) {
      choose(window, last.text() + button, heard);
    }
    assertThat(heard).containsExactly(last.id() + " yes", last.id() + " yes3", last.id() + " no3");
    assertThat(Hands.onEdt(Hands.named(window, "Continue", JButton.class)::isEnabled)).isFalse();
    OpenWindow.close(window);
    hands.await("the question", () -> closings.get() == 1);
    assertThat(asked.isDone()).isFalse();
    over.set(true);
    assertThat(OpenWindow.answer(asked)).isFalse();
  }

  @Test
  void expectancyIsRatedFromOneToSix() throws IOException {
    material("en");
    StudyMaterial pilot =
        StudyMaterial.read(folder.resolve("study/pilot/study.json"), new Problems()).orElseThrow();
    Questionnaire screen = pilot.questionnaires("001").get(1); // The first is the example.
    List<String> heard = new CopyOnWriteArrayList<>();
    FutureTask<Boolean> asked = asking(pilot, screen, false, heard);
    JFrame window = OpenWindow.named(hands, "questionnaire");
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
    assertThat(OpenWindow.answer(asked)).isFalse();
  }

  private StudyMaterial ofKinds(String questionnaire) throws IOException {
    Files.writeString(folder.resolve("all.json"), questionnaire);
    Path file = folder.resolve("kinds.json");
    Files.writeString(
        file,
        """
        {"name": "Kinds", "conditions": ["high"], "participants": 1,
         "questionnaires": [{"file": "all.json"}]}
        """);
    return StudyMaterial.read(file, new Problems()).orElseThrow();
  }

  @Test
  void allKindsAreAnsweredByKeysPageByPageAndBack() throws IOException {
    StudyMaterial material =
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
    JFrame window = OpenWindow.named(hands, "questionnaire");
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
    assertThat(OpenWindow.answer(asked)).isTrue();
    assertThat(pages).containsExactly("read", "ask", "feel", "ask", "feel");
  }

  private static JTextComponent named(JFrame window, String name) {
    return Hands.named(window, name, JTextComponent.class);
  }

  @Test
  void theExperimentersNotesPausesAndEndAreInTheJournal() throws IOException {
    StudyMaterial material = material("en");
    try (Session session =
        Session.begin(
            material,
            "001",
            1,
            new SessionOptions(Optional.empty(), OptionalDouble.empty(), false, "test"),
            new Problems())) {
      OperatorControls controls = new OperatorControls(session.journal());
      assertThat(controls.askAbort()).as("nobody there to ask").isFalse();
      ControlWindow opened = ControlWindow.open(controls, DesktopPlace.USUAL);
      try {
        JFrame window = OpenWindow.named(hands, "controls");
        controls.status("exposure-kitchen: 12 s left");
        JTextField note = Hands.named(window, "Note to keep", JTextField.class);
        OpenWindow.click(hands, note, note::isFocusOwner);
        hands.type("7");
        hands.await("the note", () -> note.getText().equals("7"));
        hands.press(KeyEvent.VK_ENTER);
        JToggleButton pause = Hands.named(window, "Pause (F8)", JToggleButton.class);
        OpenWindow.click(hands, pause, controls::paused);
        JLabel status =
            Hands.onEdt(
                () ->
                    (JLabel)
                        ((BorderLayout) window.getContentPane().getLayout())
                            .getLayoutComponent(BorderLayout.NORTH));
        hands.await("the status", () -> status.getText().startsWith("exposure-kitchen: 12 s left"));
        pictures(window, "session-controls");
        OpenWindow.click(hands, pause, () -> !controls.paused());
        AtomicBoolean went = new AtomicBoolean(); // Taken once.
        OpenWindow.click(
            hands,
            Hands.named(window, "Go on (F9)", JButton.class),
            () -> {
              if (controls.takeGoOn()) {
                went.set(true);
              }
              return went.get();
            });
        AtomicBoolean reset = new AtomicBoolean(); // Taken once.
        OpenWindow.click(
            hands,
            Hands.named(window, "Reset Heading (F4)", JButton.class),
            () -> {
              if (controls.takeResetHeading()) {
                reset.set(true);
              }
              return reset.get();
            });
        hands.press(KeyEvent.VK_F8);
        hands.await("the pause", controls::paused);
        hands.await("the button", () -> pause.getText().equals("Continue (F8)"));
        hands.press(KeyEvent.VK_F8);
        hands.await("no pause", () -> !controls.paused());
        OpenWindow.click(
            hands, Hands.named(window, "Abort ...", JButton.class), OpenWindow::asking);
        OpenWindow.answerDialog(hands, "Continue the Session");
        assertThat(controls.aborted()).isFalse();
        OpenWindow.close(window);
        OpenWindow.answerDialog(hands, "Continue the Session");
        assertThat(controls.askAbort()).isTrue();
        assertThat(controls.askAbort()).as("asked once").isTrue();
        OpenWindow.answerDialog(hands, "End the Session");
        hands.await("the end", controls::aborted);
      } finally {
        opened.close();
      }
      session.abort("form");
    }
    String events = Files.readString(folder.resolve("study/sub-001/ses-01/events.jsonl"));
    assertThat(events.lines().map(line -> line.replaceAll(".*\"event\":\"([^\"]*)\".*", "$1")))
        .containsExactly(
            "session-began",
            "note",
            "paused",
            "continued",
            "go-on",
            "paused",
            "continued",
            "aborted");
    assertThat(events).containsPattern("\"time\":\"\\d{4}-.*\"event\":\"note\",\"text\":\"7\"");
  }

  @Test
  void thanksGoWhenTheyAreClosed() throws IOException {
    Wording wording = material("en").wording();
    FutureTask<Boolean> shown =
        OpenWindow.asking(
            () -> {
              ThanksWindow.show(wording, desk);
              return true;
            });
    JFrame thanks = OpenWindow.named(hands, "thanks");
    pictures(thanks, "session-thanks");
    OpenWindow.close(thanks);
    assertThat(OpenWindow.answer(shown)).isTrue();
  }
}
