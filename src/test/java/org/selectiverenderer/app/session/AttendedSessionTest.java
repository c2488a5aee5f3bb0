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
import org.selectiverenderer.app.head.ChainTracker;
import org.selectiverenderer.app.run.RunListener;
import org.selectiverenderer.app.timeline.TimelineEvent;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.enricher.driving.Hands;
import org.selectiverenderer.experiment.session.Session;
import org.selectiverenderer.experiment.session.SessionOptions;
import org.selectiverenderer.experiment.session.StudyMaterial;
import org.selectiverenderer.hmd.DisplayMode;
import org.selectiverenderer.hmd.DisplayProfile;
import org.selectiverenderer.hmd.EyeGeometry;
import org.selectiverenderer.hmd.Presentation;
import org.selectiverenderer.testing.OpenWindow;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.tracker.TrackerOptions;

/** A session with participant and experimenter at the windows; all that is shown is white. */
@ShowsWindows
@Timeout(value = 120, unit = TimeUnit.SECONDS)
class AttendedSessionTest {
  /** Milliseconds between two looks at the picture, which fades over 400. */
  private static final int LOOK = 15;

  private static final Rectangle WITHIN_THE_PICTURE = new Rectangle(60, 60, 80, 60);

  @TempDir Path folder;
  private final Hands hands = new Hands();
  private final List<Boolean> flips = new CopyOnWriteArrayList<>();
  private final AtomicBoolean watching = new AtomicBoolean(true);
  private @Nullable StudyMaterial material;
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
    material = StudyMaterial.read(folder.resolve("study.json"), new Problems()).orElseThrow();
  }

  @AfterEach
  void leave() {
    watching.set(false);
    OpenWindow.closeAll();
  }

  @Test
  void fromTheFormToTheThanksWithAPauseAndWithoutAFlash() throws IOException {
    FutureTask<SessionRunner.Outcome> session = OpenWindow.asking(() -> run(1));
    FutureTask<Boolean> picture = OpenWindow.asking(this::watch);
    fillInTheForm();
    status("practice: 1 s so far");
    press("Go on (F9)", () -> shows("exposure-hall: "));
    press("Pause (F8)", () -> shows("exposure-hall: PAUSED"));
    press("Continue (F8)", () -> !shows("exposure-hall: PAUSED"));
    JFrame questions = OpenWindow.named(hands, "questionnaire");
    watching.set(false);
    OpenWindow.answer(picture);
    JToggleButton yes = Hands.named(questions, "Coat: Yes", JToggleButton.class);
    OpenWindow.click(hands, yes, yes::isSelected);
    JButton next = Hands.named(questions, "Continue", JButton.class);
    OpenWindow.click(
        hands, Hands.named(questions, "Coat: 5", JToggleButton.class), next::isEnabled);
    OpenWindow.click(hands, next, () -> !questions.isShowing());
    OpenWindow.close(OpenWindow.named(hands, "thanks"));
    assertThat(OpenWindow.answer(session)).isEqualTo(SessionRunner.Outcome.FINISHED);
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
    FutureTask<SessionRunner.Outcome> first = OpenWindow.asking(() -> run(1));
    OpenWindow.named(hands, "questionnaire");
    controls = OpenWindow.named(hands, "controls");
    OpenWindow.move(controls, 640, 700); // Not over the picture.
    abort();
    assertThat(OpenWindow.answer(first)).isEqualTo(SessionRunner.Outcome.ABORTED);
    assertThat(events(1)).doesNotContain("refused").endsWith("aborted");

    FutureTask<SessionRunner.Outcome> second = OpenWindow.asking(() -> run(2));
    fillInTheForm();
    status("practice: 1 s so far");
    press("Go on (F9)", () -> shows("exposure-hall: "));
    abort();
    assertThat(OpenWindow.answer(second)).isEqualTo(SessionRunner.Outcome.ABORTED);
    assertThat(events(2)).endsWith("step-began", "scene", "shown", "aborted");
  }

  private SessionRunner.Outcome run(int number) throws IOException, InterruptedException {
    try (Session session =
            Session.begin(
                material,
                "001",
                number,
                new SessionOptions(Optional.empty(), OptionalDouble.of(8), false, "test"),
                new Problems());
        ChainTracker tracker = new ChainTracker();
        SessionDialogue dialogue = new WindowDialogue(material.wording(), SessionStage.DESK)) {
      return new SessionRunner(session, dialogue, show(), tracker, text -> {}).run();
    }
  }

  private static SessionShow show() {
    return new SessionShow(
        new Presentation(
            DisplayMode.WINDOW, new EyeGeometry(DisplayProfile.PROVIEW_50, 0.063), false),
        TrackerOptions.NONE,
        false,
        SessionStage.DESK,
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
    boolean bright = false;
    while (watching.get()) {
      double now = brightness(robot.createScreenCapture(WITHIN_THE_PICTURE));
      if (bright ? now < 0.1 : now > 0.985) {
        bright = !bright;
        flips.add(bright);
      }
      robot.delay(LOOK); // Or there is no processor left for what is to be watched.
    }
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
    JFrame form = OpenWindow.named(hands, "questionnaire");
    controls = OpenWindow.named(hands, "controls");
    OpenWindow.move(controls, 640, 700); // Not over the picture.
    JToggleButton age = Hands.named(form, "Age: 18-22", JToggleButton.class);
    OpenWindow.click(hands, age, age::isSelected);
    String asked = material.form().questions().get(0).text();
    JToggleButton consent = Hands.named(form, asked + ": Yes", JToggleButton.class);
    OpenWindow.click(hands, consent, consent::isSelected);
    JButton begin = Hands.named(form, "Begin", JButton.class);
    OpenWindow.click(hands, begin, () -> !form.isShowing());
  }

  private void status(String begins) {
    hands.await("the status " + begins, () -> controls.isShowing() && shows(begins));
  }

  private boolean shows(String begins) {
    return Arrays.stream(controls.getContentPane().getComponents())
        .anyMatch(part -> part instanceof JLabel label && label.getText().startsWith(begins));
  }

  private void press(String button, BooleanSupplier effect) {
    OpenWindow.click(
        hands,
        button.startsWith("Go on")
            ? Hands.named(controls, button, JButton.class)
            : Hands.named(controls, button, JToggleButton.class),
        effect);
  }

  private void abort() {
    JButton abort = Hands.named(controls, "Abort ...", JButton.class);
    OpenWindow.click(hands, abort, OpenWindow::asking);
    OpenWindow.answerDialog(hands, "End the Session");
  }

  private List<String> events(int number) throws IOException {
    return Files.readAllLines(folder.resolve("sub-001/ses-0" + number + "/events.jsonl")).stream()
        .map(line -> line.replaceAll(".*?\"event\":\"([^\"]*)\".*", "$1"))
        .toList();
  }
}
