package org.selectiverenderer.app.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.AWTException;
import java.awt.Color;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.BooleanSupplier;
import javax.swing.JButton;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JToggleButton;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.app.head.SharedHeadTracker;
import org.selectiverenderer.app.run.RunListener;
import org.selectiverenderer.apparatus.DisplayMode;
import org.selectiverenderer.apparatus.DisplayProfile;
import org.selectiverenderer.apparatus.EyeGeometry;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.hmd.DisplayConfiguration;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.session.Session;
import org.selectiverenderer.study.session.SessionOptions;
import org.selectiverenderer.testing.Eventually;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.testing.WindowFinder;
import org.selectiverenderer.testing.robot.GuiRobot;
import org.selectiverenderer.tracker.TrackerOptions;
import org.selectiverenderer.walkthrough.timeline.TimelineEvent;

/** A session with participant and experimenter at the windows; all that is shown is white. */
@ShowsWindows
@Timeout(value = 120, unit = TimeUnit.SECONDS)
class AttendedSessionTest {
  private static final Rectangle WITHIN_THE_PICTURE = new Rectangle(60, 60, 80, 60);

  @TempDir Path folder;
  private final GuiRobot hands = new GuiRobot();
  private final List<Boolean> flips = new CopyOnWriteArrayList<>();
  private final AtomicBoolean watching = new AtomicBoolean(true);
  private @Nullable LoadedStudy material;
  private @Nullable JFrame controls;

  @BeforeEach
  void study() throws IOException {
    Files.writeString(
        folder.resolve("white.x3d"),
        """
        <X3D version='4.0' profile='Immersive'><Scene>
        <Viewpoint DEF='Here'/><Background skyColor='1 1 1'/>
        <Shape><Sphere radius='0.1'/></Shape>
        </Scene></X3D>
        """);
    Files.writeString(
        folder.resolve("items.csv"),
        "area,object,consistency,present,en\nhall,coat,consistent,yes,Coat\n");
    Files.writeString(
        folder.resolve("study.json"),
        """
        {"name": "White", "conditions": ["high"], "participants": 1, "scene": "white.x3d",
         "practice": {"scene": "white.x3d", "viewpoint": "Here"}, "fade": 0.4, "mouse": "off",
         "areas": [{"name": "hall", "viewpoint": "Here", "seconds": 45},
                   {"name": "bath", "viewpoint": "Here", "seconds": 1}],
         "display": {"width": 320, "height": 240},
         "questionnaires": [{"kind": "recognition", "items": "items.csv"}]}
        """);
    material = LoadedStudy.read(folder.resolve("study.json"), new ProblemCollector()).orElseThrow();
  }

  @AfterEach
  void leave() {
    watching.set(false);
    WindowFinder.closeAll();
  }

  @Test
  void fromTheFormToTheThanksWithAPauseAndWithoutAFlash() throws IOException {
    FutureTask<SessionRunner.Outcome> session = WindowFinder.asking(() -> run(1));
    FutureTask<Boolean> picture = WindowFinder.asking(this::watch);
    fillInTheForm();
    status("practice: 1 s so far");
    press("Go on (F9)", () -> shows("exposure-hall: "));
    press("Pause (F8)", () -> shows("exposure-hall: PAUSED"));
    press("Continue (F8)", () -> !shows("exposure-hall: PAUSED"));
    JFrame questions = WindowFinder.named(hands, "questionnaire");
    watching.set(false);
    WindowFinder.answer(picture);
    JToggleButton yes = GuiRobot.named(questions, "Coat: Yes", JToggleButton.class);
    WindowFinder.click(hands, yes, yes::isSelected);
    JButton next = GuiRobot.named(questions, "Continue", JButton.class);
    WindowFinder.click(
        hands, GuiRobot.named(questions, "Coat: 5", JToggleButton.class), next::isEnabled);
    WindowFinder.click(hands, next, () -> !questions.isShowing());
    WindowFinder.close(WindowFinder.named(hands, "thanks"));
    assertThat(WindowFinder.answer(session)).isEqualTo(SessionRunner.Outcome.FINISHED);
    // Practice, hall until the pause, hall after it, bath: each comes once and goes once.
    assertThat(flips).containsExactly(true, false, true, false, true, false, true, false);
    assertThat(events(1))
        .containsSubsequence(
            "assigned", "shown", "go-on", "step-finished", "shown", "paused", "continued")
        .doesNotContain("problem")
        .endsWith("session-finished");
    assertThat(folder.resolve("sub-001/ses-01/responses.csv"))
        .content()
        .containsPattern("\n001,high,hall,coat,consistent,yes,yes,5,\\d+,1\n$");
    assertThat(folder.resolve("sub-001/ses-01/motion")).isDirectoryContaining("glob:**bath*.tsv");
  }

  @Test
  void theExperimenterEndsASessionAtTheFormAndDuringAnExposure() throws IOException {
    FutureTask<SessionRunner.Outcome> first = WindowFinder.asking(() -> run(1));
    WindowFinder.named(hands, "questionnaire");
    controls = WindowFinder.named(hands, "controls");
    WindowFinder.move(controls, 640, 700); // Not over the picture.
    abort();
    assertThat(WindowFinder.answer(first)).isEqualTo(SessionRunner.Outcome.ABORTED);
    assertThat(events(1)).doesNotContain("refused").endsWith("aborted");

    FutureTask<SessionRunner.Outcome> second = WindowFinder.asking(() -> run(2));
    fillInTheForm();
    status("practice: 1 s so far");
    press("Go on (F9)", () -> shows("exposure-hall: "));
    abort();
    assertThat(WindowFinder.answer(second)).isEqualTo(SessionRunner.Outcome.ABORTED);
    assertThat(events(2)).endsWith("step-began", "scene", "shown", "aborted");
  }

  private SessionRunner.Outcome run(int number) throws IOException, InterruptedException {
    try (Session session =
            Session.begin(
                material,
                "001",
                number,
                new SessionOptions(Optional.empty(), OptionalDouble.of(8), false, "test"),
                new ProblemCollector());
        SharedHeadTracker tracker = new SharedHeadTracker();
        SessionUi dialogue = new SwingSessionUi(material.wording(), OperatorViewSettings.DESK)) {
      return new SessionRunner(session, dialogue, show(), tracker, text -> {}).run();
    }
  }

  private static SessionDisplaySettings show() {
    return new SessionDisplaySettings(
        new DisplayConfiguration(
            DisplayMode.WINDOW, new EyeGeometry(DisplayProfile.PROVIEW_50, 0.063), false),
        TrackerOptions.NONE,
        false,
        OperatorViewSettings.DESK,
        new RunListener() {
          @Override
          public void problem(Problem problem) {
            throw new AssertionError(problem);
          }

          @Override
          public void happened(TimelineEvent event) {
            throw new AssertionError(event);
          }

          @Override
          public void printed(String text) {
            throw new AssertionError(text);
          }
        });
  }

  /**
   * Notes when the picture turns from dark to white and back; windows that come by are less than
   * white.
   */
  private boolean watch() throws AWTException {
    Robot robot = new Robot();
    AtomicBoolean bright = new AtomicBoolean();
    Eventually.within(
        10,
        TimeUnit.MINUTES,
        () -> {
          double now = brightness(robot.createScreenCapture(WITHIN_THE_PICTURE));
          if (bright.get() ? now < 0.1 : now > 0.985) {
            bright.set(!bright.get());
            flips.add(bright.get());
          }
          return !watching.get();
        });
    return true;
  }

  private static double brightness(BufferedImage image) {
    double sum = 0;
    for (int y = 0; y < image.getHeight(); y++) {
      for (int x = 0; x < image.getWidth(); x++) {
        sum += new Color(image.getRGB(x, y)).getGreen() / 255.0;
      }
    }
    return sum / (image.getWidth() * image.getHeight());
  }

  private void fillInTheForm() {
    JFrame form = WindowFinder.named(hands, "questionnaire");
    controls = WindowFinder.named(hands, "controls");
    WindowFinder.move(controls, 640, 700); // Not over the picture.
    JToggleButton age = GuiRobot.named(form, "Age: 18-22", JToggleButton.class);
    WindowFinder.click(hands, age, age::isSelected);
    String asked = material.form().questions().get(0).text();
    JToggleButton consent = GuiRobot.named(form, asked + ": Yes", JToggleButton.class);
    WindowFinder.click(hands, consent, consent::isSelected);
    JButton begin = GuiRobot.named(form, "Begin", JButton.class);
    WindowFinder.click(hands, begin, () -> !form.isShowing());
  }

  private void status(String begins) {
    hands.await("the status " + begins, () -> controls.isShowing() && shows(begins));
  }

  private boolean shows(String begins) {
    return Arrays.stream(controls.getContentPane().getComponents())
        .anyMatch(part -> part instanceof JLabel label && label.getText().startsWith(begins));
  }

  private void press(String button, BooleanSupplier effect) {
    WindowFinder.click(
        hands,
        button.startsWith("Go on")
            ? GuiRobot.named(controls, button, JButton.class)
            : GuiRobot.named(controls, button, JToggleButton.class),
        effect);
  }

  private void abort() {
    JButton abort = GuiRobot.named(controls, "Abort ...", JButton.class);
    WindowFinder.click(hands, abort, WindowFinder::asking);
    WindowFinder.answerDialog(hands, "End the Session");
  }

  private List<String> events(int number) throws IOException {
    return Files.readAllLines(folder.resolve("sub-001/ses-0" + number + "/events.jsonl")).stream()
        .map(line -> line.replaceAll(".*?\"event\":\"([^\"]*)\".*", "$1"))
        .toList();
  }
}
