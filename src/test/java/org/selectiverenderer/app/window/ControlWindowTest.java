package org.selectiverenderer.app.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.BorderLayout;
import java.awt.Container;
import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.util.Arrays;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.FutureTask;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import javax.swing.JButton;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import javax.swing.JToggleButton;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.study.questionnaire.ParticipantMessages;
import org.selectiverenderer.study.session.ExperimenterControls;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.session.Session;
import org.selectiverenderer.study.session.SessionOptions;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.testing.WindowFinder;
import org.selectiverenderer.testing.robot.GuiRobot;

/** The experimenter's window, where windows are put, and the last one. */
@ShowsWindows
class ControlWindowTest extends SessionWindowFixture {
  @Test
  void windowsArePutIntoTheMiddleOfTheMonitorThatIsNotBeforeAnEye() {
    // As beside an eye's monitor of 290 pixels.
    MonitorBounds beside = new MonitorBounds(0, 290, 0, 990, 700);
    Rectangle window =
        GuiRobot.onEdt(
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

  private static Optional<JTextArea> alarm(Container within) {
    return Arrays.stream(within.getComponents())
        .map(
            part ->
                part instanceof JTextArea text && "alarm".equals(text.getName())
                    ? Optional.of(text)
                    : part instanceof Container more ? alarm(more) : Optional.<JTextArea>empty())
        .flatMap(Optional::stream)
        .findFirst();
  }

  @Test
  void theExperimentersNotesPausesAndEndAreInTheJournal() throws IOException {
    LoadedStudy material = material("en");
    try (Session session =
        Session.begin(
            material,
            "001",
            1,
            new SessionOptions(Optional.empty(), OptionalDouble.empty(), false, "test"),
            new ProblemCollector())) {
      ExperimenterControls controls = new ExperimenterControls(session.journal());
      assertThat(controls.askAbort()).as("nobody there to ask").isFalse();
      ControlWindow opened = ControlWindow.open(controls, MonitorBounds.USUAL);
      try {
        JFrame window = WindowFinder.named(hands, "controls");
        controls.status("exposure-kitchen: 12 s left");
        JTextField note = GuiRobot.named(window, "Note to keep", JTextField.class);
        WindowFinder.click(hands, note, note::isFocusOwner);
        hands.type("7");
        hands.await("the note", () -> note.getText().equals("7"));
        hands.press(KeyEvent.VK_ENTER);
        JToggleButton pause = GuiRobot.named(window, "Pause (F8)", JToggleButton.class);
        WindowFinder.click(hands, pause, controls::paused);
        JLabel status =
            GuiRobot.onEdt(
                () ->
                    (JLabel)
                        ((BorderLayout) window.getContentPane().getLayout())
                            .getLayoutComponent(BorderLayout.NORTH));
        hands.await("the status", () -> status.getText().startsWith("exposure-kitchen: 12 s left"));
        pictures(window, "session-controls");
        JTextArea alarm = GuiRobot.onEdt(() -> alarm(window).orElseThrow());
        assertThat(alarm.isVisible()).isFalse();
        controls.alarm("The tracker is silent for 3.0 s: the view stays as it is");
        hands.await("the alarm", alarm::isShowing);
        assertThat(alarm.getText())
            .contains("The tracker is silent for 3.0 s", "F8 pauses", "F9 goes on", "Abort")
            .contains("--resume --without-tracker");
        pictures(window, "session-alarm");
        controls.alarm("");
        hands.await("no alarm", () -> !alarm.isShowing());
        WindowFinder.click(hands, pause, () -> !controls.paused());
        AtomicBoolean went = new AtomicBoolean(); // Taken once.
        WindowFinder.click(
            hands,
            GuiRobot.named(window, "Go on (F9)", JButton.class),
            () -> {
              if (controls.takeGoOn()) {
                went.set(true);
              }
              return went.get();
            });
        AtomicBoolean reset = new AtomicBoolean(); // Taken once.
        WindowFinder.click(
            hands,
            GuiRobot.named(window, "Reset Heading (F4)", JButton.class),
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
        WindowFinder.click(
            hands, GuiRobot.named(window, "Abort ...", JButton.class), WindowFinder::asking);
        WindowFinder.answerDialog(hands, "Continue the Session");
        assertThat(controls.aborted()).isFalse();
        WindowFinder.close(window);
        WindowFinder.answerDialog(hands, "Continue the Session");
        assertThat(controls.askAbort()).isTrue();
        assertThat(controls.askAbort()).as("asked once").isTrue();
        WindowFinder.answerDialog(hands, "End the Session");
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
  void calibrationsAreMarkedByButtonAndKeyWhereADeviceRecords() throws IOException {
    try (Session session =
        Session.begin(
            material("en"),
            "001",
            1,
            new SessionOptions(Optional.empty(), OptionalDouble.empty(), false, "test"),
            new ProblemCollector())) {
      AtomicInteger marks = new AtomicInteger();
      session
          .journal()
          .listen(
              event -> marks.addAndGet(event.path("event").asText().equals("calibration") ? 1 : 0));
      ControlWindow opened =
          ControlWindow.open(
              new ExperimenterControls(session.journal(), true), MonitorBounds.USUAL);
      try {
        JFrame window = WindowFinder.named(hands, "controls");
        pictures(window, "session-controls-calibrated");
        JButton calibrated = GuiRobot.named(window, "Calibrated (F6)", JButton.class);
        WindowFinder.click(hands, calibrated, () -> marks.get() > 0);
        int before = marks.get();
        hands.press(KeyEvent.VK_F6);
        hands.await("the key's mark", () -> marks.get() == before + 1);
      } finally {
        opened.close();
      }
    }
    assertThat(Files.readString(folder.resolve("study/sub-001/ses-01/events.jsonl")))
        .contains("\"event\":\"calibration\",\"by\":\"experimenter\"");
  }

  @Test
  void withoutSuchADeviceThereIsNoButton() throws IOException {
    try (Session session =
        Session.begin(
            material("en"),
            "001",
            1,
            new SessionOptions(Optional.empty(), OptionalDouble.empty(), false, "test"),
            new ProblemCollector())) {
      ExperimenterControls controls = new ExperimenterControls(session.journal());
      controls.calibrated();
    }
    assertThat(Files.readString(folder.resolve("study/sub-001/ses-01/events.jsonl")))
        .doesNotContain("calibration");
  }

  @Test
  void thanksGoWhenTheyAreClosed() throws IOException {
    ParticipantMessages wording = material("en").wording();
    FutureTask<Boolean> shown =
        WindowFinder.asking(
            () -> {
              ThanksWindow.show(wording, desk);
              return true;
            });
    JFrame thanks = WindowFinder.named(hands, "thanks");
    pictures(thanks, "session-thanks");
    WindowFinder.close(thanks);
    assertThat(WindowFinder.answer(shown)).isTrue();
  }
}
