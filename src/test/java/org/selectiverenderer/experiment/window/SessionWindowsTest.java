package org.selectiverenderer.experiment.window;

import static org.assertj.core.api.Assertions.assertThat;

import com.formdev.flatlaf.FlatLightLaf;
import java.awt.BorderLayout;
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
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JRadioButton;
import javax.swing.JTextField;
import javax.swing.JToggleButton;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.enricher.driving.Hands;
import org.selectiverenderer.experiment.questionnaire.Screen;
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
  private final Hands hands = new Hands();
  private final AtomicBoolean over = new AtomicBoolean();
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
    return StudyMaterial.read(file, new Problems()).orElseThrow();
  }

  private static void pictures(JFrame frame, String name) {
    Hands.picture(frame.getContentPane(), name, 1);
    Hands.picture(frame.getContentPane(), name + "-200", 2);
  }

  @Test
  void theFormGoesOnWithAnAgeAndConsentOnly() throws IOException {
    Wording wording = material("en").wording();
    FutureTask<Optional<String>> asked =
        OpenWindow.asking(() -> FormWindow.ask("007", wording, end));
    JFrame form = OpenWindow.named(hands, "form");
    JButton begin = Hands.named(form, "Begin", JButton.class);
    hands.click(begin);
    JRadioButton age = Hands.named(form, "28-32", JRadioButton.class);
    OpenWindow.click(hands, age, age::isSelected);
    assertThat(Hands.onEdt(begin::isEnabled)).isFalse();
    JCheckBox consent = Hands.named(form, wording.of("form.consent"), JCheckBox.class);
    OpenWindow.click(hands, consent, consent::isSelected);
    hands.await("Begin", begin::isEnabled);
    pictures(form, "session-form");
    OpenWindow.click(hands, begin, () -> !form.isShowing());
    assertThat(OpenWindow.answer(asked)).contains("28-32");
  }

  @Test
  void theFormSaysWhoDoesNotTakePart() throws IOException {
    Wording wording = material("el").wording();
    FutureTask<Optional<String>> asked =
        OpenWindow.asking(() -> FormWindow.ask("007", wording, end));
    JFrame form = OpenWindow.named(hands, "form");
    pictures(form, "session-form-greek");
    JButton cancel = Hands.named(form, wording.of("form.cancel"), JButton.class);
    OpenWindow.click(hands, cancel, () -> !form.isShowing());
    assertThat(OpenWindow.answer(asked)).isEmpty();
  }

  @Test
  void closingTheFormAsksAndTheFormGoesWithTheSessionOnly() throws IOException {
    Wording wording = material("en").wording();
    FutureTask<Optional<String>> asked =
        OpenWindow.asking(() -> FormWindow.ask("007", wording, end));
    JFrame form = OpenWindow.named(hands, "form");
    OpenWindow.close(form);
    hands.await("the question", () -> closings.get() == 1);
    assertThat(Hands.onEdt(form::isShowing)).isTrue();
    assertThat(asked.isDone()).isFalse();
    over.set(true);
    assertThat(OpenWindow.answer(asked)).isEmpty();
    hands.await("the form to go", () -> !form.isShowing());
  }

  private FutureTask<Boolean> asking(StudyMaterial material, Screen screen, List<String> heard) {
    return OpenWindow.asking(
        () ->
            QuestionnaireWindow.ask(
                screen,
                material.wording(),
                Map.of(),
                (item, answer) ->
                    heard.add(item.object() + " " + answer.value() + answer.confidence()),
                end));
  }

  @ParameterizedTest
  @ValueSource(strings = {"en", "el"})
  void keysAnswerAScreenRowByRow(String language) throws IOException {
    StudyMaterial material = material(language);
    Screen screen = material.screens("001").get(3);
    List<String> heard = new CopyOnWriteArrayList<>();
    FutureTask<Boolean> asked = asking(material, screen, heard);
    JFrame window = OpenWindow.named(hands, "questionnaire");
    JLabel title = Hands.named(window, window.getTitle(), JLabel.class);
    hands.click(title);
    OpenWindow.click(hands, title, window::isFocused);
    List<String> expected = new ArrayList<>();
    for (int row = 0; row < screen.items().size(); row++) {
      boolean yes = row % 2 == 0;
      int confidence = 1 + row % 5;
      hands.press(yes ? KeyEvent.VK_Y : KeyEvent.VK_N);
      hands.press(KeyEvent.VK_0 + confidence);
      String object = screen.items().get(row).object();
      expected.add(object + (yes ? " yes0" : " no0"));
      expected.add(object + (yes ? " yes" : " no") + confidence);
      hands.await("both answers", () -> heard.size() >= expected.size());
      if (row == screen.items().size() / 2) {
        hands.press(KeyEvent.VK_ENTER);
        assertThat(asked.isDone()).as("Enter while answers are wanting").isFalse();
        pictures(window, "session-questionnaire-" + language);
      }
    }
    hands.press(KeyEvent.VK_ENTER);
    assertThat(OpenWindow.answer(asked)).isTrue();
    assertThat(heard).isEqualTo(expected);
  }

  @Test
  void theMouseAnswersAndChangesAnswersInAnyOrder() throws IOException {
    StudyMaterial material = material("en");
    Screen screen = material.screens("001").get(3);
    String last = screen.items().get(screen.items().size() - 1).object();
    String name = material.wording().name(screen.items().get(screen.items().size() - 1));
    List<String> heard = new CopyOnWriteArrayList<>();
    FutureTask<Boolean> asked = asking(material, screen, heard);
    JFrame window = OpenWindow.named(hands, "questionnaire");
    List<String> buttons = List.of(": Yes", ": 3", ": No");
    for (int i = 0; i < buttons.size(); i++) {
      int answers = i + 1;
      JToggleButton button = Hands.named(window, name + buttons.get(i), JToggleButton.class);
      OpenWindow.click(hands, button, () -> heard.size() == answers);
    }
    assertThat(heard).containsExactly(last + " yes0", last + " yes3", last + " no3");
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
    Screen screen = pilot.screens("001").get(1); // The first is the example.
    List<String> heard = new CopyOnWriteArrayList<>();
    FutureTask<Boolean> asked = asking(pilot, screen, heard);
    JFrame window = OpenWindow.named(hands, "questionnaire");
    JLabel title = Hands.named(window, window.getTitle(), JLabel.class);
    hands.click(title);
    OpenWindow.click(hands, title, window::isFocused);
    hands.press(KeyEvent.VK_6);
    hands.press(KeyEvent.VK_7);
    hands.press(KeyEvent.VK_DOWN);
    hands.press(KeyEvent.VK_1);
    hands.await("two answers", () -> heard.size() == 2);
    pictures(window, "session-expectancy");
    assertThat(heard)
        .containsExactly(
            screen.items().get(0).object() + " 60", screen.items().get(2).object() + " 10");
    over.set(true);
    assertThat(OpenWindow.answer(asked)).isFalse();
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
      ControlWindow opened = ControlWindow.open(controls);
      try {
        JFrame window = OpenWindow.named(hands, "controls");
        controls.status("exposure-kitchen: 12 s left");
        JTextField note = Hands.named(window, "Note to keep", JTextField.class);
        OpenWindow.click(hands, note, note::isFocusOwner);
        hands.type("7");
        hands.await("the note", () -> note.getText().equals("7"));
        hands.press(KeyEvent.VK_ENTER);
        JToggleButton pause = Hands.named(window, "Pause", JToggleButton.class);
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
            Hands.named(window, "Go on", JButton.class),
            () -> {
              if (controls.takeGoOn()) {
                went.set(true);
              }
              return went.get();
            });
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
        .containsExactly("session-began", "note", "paused", "continued", "go-on", "aborted");
    assertThat(events).containsPattern("\"time\":\"\\d{4}-.*\"event\":\"note\",\"text\":\"7\"");
  }

  @Test
  void thanksGoWhenTheyAreClosed() throws IOException {
    Wording wording = material("en").wording();
    FutureTask<Boolean> shown =
        OpenWindow.asking(
            () -> {
              ThanksWindow.show(wording);
              return true;
            });
    JFrame thanks = OpenWindow.named(hands, "thanks");
    pictures(thanks, "session-thanks");
    OpenWindow.close(thanks);
    assertThat(OpenWindow.answer(shown)).isTrue();
  }
}
