package org.selectiverenderer.app.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javax.imageio.ImageIO;
import org.joml.Matrix4dc;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.app.headset.ControllerCommand;
import org.selectiverenderer.app.headset.PanelPlacement;
import org.selectiverenderer.app.narration.SilentNarration;
import org.selectiverenderer.app.run.RunController;
import org.selectiverenderer.app.run.RunListener;
import org.selectiverenderer.app.run.RunRequest;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.camera.Primitive2D;
import org.selectiverenderer.browser.camera.WorldSpacePanel;
import org.selectiverenderer.browser.viewer.Viewer;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.hmd.DisplayConfiguration;
import org.selectiverenderer.hmd.HeadsetViewSettings;
import org.selectiverenderer.openxr.HeadsetEvent;
import org.selectiverenderer.openxr.XrPose;
import org.selectiverenderer.study.questionnaire.Answer;
import org.selectiverenderer.study.session.ExperimenterControls;
import org.selectiverenderer.study.session.Session;
import org.selectiverenderer.study.session.SessionStep;
import org.selectiverenderer.tracker.TrackerOptions;
import org.selectiverenderer.walkthrough.Walkthrough;
import org.selectiverenderer.walkthrough.timeline.TimelineEvent;

/** Questions inside the headset, and what becomes of a session whose headset goes. */
class HeadsetQuestionControllerTest {
  @TempDir private Path folder;
  private final List<String> told = new ArrayList<>();
  private final ProblemCollector problems = new ProblemCollector();
  private Session session;
  private ExperimenterControls controls;
  private SessionRunProvider steps;

  @BeforeEach
  void begin() throws IOException {
    Files.writeString(
        folder.resolve("rooms.x3d"),
        "<X3D version='4.0' profile='Immersive'><Scene>"
            + "<Viewpoint DEF='Here' position='0 1.6 0'/></Scene></X3D>");
    Files.writeString(
        folder.resolve("items.csv"),
        "area,object,consistency,present,en\nhall,cube,consistent,yes,a cube\n");
    Files.writeString(
        folder.resolve("words.json"),
        """
        {"name": "words", "pages": [{"name": "w", "picture": "hall.png", "questions": [
          {"id": "say", "kind": "text", "text": "Anything else?"}]}]}
        """);
    BufferedImage hall = new BufferedImage(2048, 1024, BufferedImage.TYPE_INT_RGB);
    hall.setRGB(0, 0, 0xFF0000);
    ImageIO.write(hall, "png", folder.resolve("hall.png").toFile());
    Path file =
        Files.writeString(
            folder.resolve("study.json"),
            """
            {"name": "Rooms", "conditions": ["selective"], "participants": 1, "scene": "rooms.x3d",
             "display": {"mode": "openxr", "questions": "headset"},
             "areas": [{"name": "hall", "viewpoint": "Here", "seconds": 1}],
             "questionnaires": [
               {"kind": "recognition", "items": "items.csv", "when": "begin"},
               {"file": "words.json"}]}
            """);
    session = StartedSession.of(file);
    controls = new ExperimenterControls(session.journal());
    steps =
        new SessionRunProvider(
            session,
            new SessionDisplaySettings(
                DisplayConfiguration.in(HeadsetViewSettings.standing()),
                TrackerOptions.NONE,
                false,
                OperatorViewSettings.DESK,
                new RunListener() {
                  @Override
                  public void problem(Problem problem) {
                    told.add(problem.toString());
                  }

                  @Override
                  public void happened(TimelineEvent event) {
                    throw new AssertionError(event);
                  }

                  @Override
                  public void printed(String text) {
                    told.add(text);
                  }
                }),
            controls,
            SilentNarration.make());
  }

  @AfterEach
  void end() throws IOException {
    session.close();
  }

  private Walkthrough scene() throws IOException {
    Walkthrough walk =
        Walkthrough.open(
            folder.resolve("rooms.x3d"),
            SelectiveController.Settings.SELECTIVE,
            p -> {},
            event -> {},
            text -> {});
    walk.step(0, (moved, time, dt) -> {});
    return walk;
  }

  private static List<String> texts(WorldSpacePanel panel) {
    return panel.marks().stream()
        .filter(Primitive2D.Text.class::isInstance)
        .map(mark -> ((Primitive2D.Text) mark).text())
        .toList();
  }

  @Test
  void whatIsWrittenIsAskedInsideToo() throws IOException {
    assertThat(problems.list()).isEmpty();
    List<SessionStep> left = session.remaining();
    assertThat(left).map(steps::shows).containsExactly(true, true, true);
    for (SessionStep step : left.subList(0, 2)) {
      session.began(step, false);
      session.finished(step, Map.of());
    }
    RunController guide = steps.next().orElseThrow().guide();
    try (Walkthrough walk = scene()) {
      guide.opened(walk);
      guide.pointed(Optional.of(new XrPose(new Vector3d(), new Quaterniond().rotationY(Math.PI))));
      for (String key :
          List.of("ABC", "h", "i", "Space", "ΕΛ", "΄", "ω", "ς", "ψ", "Erase", "Continue")) {
        choose(guide, walk, key.equals("h") ? "H" : key);
      }
      choose(guide, walk, "Continue");
      assertThat(guide.over(1)).isTrue();
    }
    assertThat(session.answers(left.get(2))).containsOnly(Map.entry("say", new Answer("Hi ώς", 0)));
  }

  @Test
  void aPageShowsItsPicture() throws IOException {
    for (SessionStep step : session.remaining().subList(0, 2)) {
      session.began(step, false);
      session.finished(step, Map.of());
    }
    RunController guide = steps.next().orElseThrow().guide();
    try (Walkthrough walk = scene()) {
      guide.opened(walk);
      Primitive2D.Picture large = picture(guide);
      assertThat(large.pixels().width()).isEqualTo(1024); // A headset shows no more.
      assertThat(large.pixels().height()).isEqualTo(512);
      assertThat(large.pixels().color(0, 0)).isNotEqualTo(0xFF000000);
      assertThat(large.pixels().color(1023, 511)).isEqualTo(0xFF000000);
      assertThat(large.width()).isEqualTo(2 * large.height());
      assertThat(2 * large.x() + large.width()).isEqualTo(QuestionPanelRenderer.WIDTH);
      guide.pointed(Optional.of(new XrPose(new Vector3d(), new Quaterniond())));
      assertThat(picture(guide).height()).isLessThan(large.height()); // There are keys below it.
      assertThat(picture(guide).pixels()).isSameAs(large.pixels());
    }
  }

  @Test
  void aPictureThatIsNoneIsNamed() throws IOException {
    for (SessionStep step : session.remaining().subList(0, 2)) {
      session.began(step, false);
      session.finished(step, Map.of());
    }
    Files.writeString(folder.resolve("hall.png"), "no picture");
    assertThatThrownBy(() -> steps.next())
        .isInstanceOf(IOException.class)
        .hasMessageContaining("hall.png is neither a PNG nor a JPEG");
  }

  private static Primitive2D.Picture picture(RunController guide) {
    return guide.panels().get(0).marks().stream()
        .filter(Primitive2D.Picture.class::isInstance)
        .map(Primitive2D.Picture.class::cast)
        .findFirst()
        .orElseThrow();
  }

  @Test
  void answersOfTheControllersAreThoseOfTheWindow() throws IOException {
    SessionStep asked = session.remaining().get(0);
    RunRequest run = steps.next().orElseThrow();
    RunController guide = run.guide();
    assertThat(run.settings().log()).isEmpty();
    assertThat(guide.walks()).isFalse();
    assertThat(guide.darkness(0)).isEqualTo(1); // There is no practice to be shown behind.
    try (Walkthrough walk = scene()) {
      guide.opened(walk);
      guide.answered(ControllerCommand.YES); // Before there is anything to read.
      assertThat(texts(guide.panels().get(0))).contains("a cube", "Yes", "No");
      controls.pause(true);
      assertThat(guide.panels()).isEmpty();
      guide.answered(ControllerCommand.NO);
      controls.pause(false);
      guide.answered(ControllerCommand.YES);
      guide.answered(ControllerCommand.MORE);
      guide.answered(ControllerCommand.MORE);
      guide.answered(ControllerCommand.YES);
      assertThat(guide.over(1)).isFalse();
      guide.answered(ControllerCommand.YES);
      assertThat(guide.over(1)).isTrue();
    }
    assertThat(session.answers(asked)).containsOnly(Map.entry("cube", new Answer("yes", 2)));
    assertThat(Files.readString(session.folder().journal()))
        .contains("\"event\":\"page\"", "\"confidence\":2", "\"place\":1");
  }

  /** A hand at the head that points at the middle of a text on the panel. */
  private static Optional<XrPose> at(RunController guide, Walkthrough walk, String text) {
    WorldSpacePanel panel = guide.panels().get(0);
    Primitive2D.Text mark =
        panel.marks().stream()
            .filter(Primitive2D.Text.class::isInstance)
            .map(Primitive2D.Text.class::cast)
            .filter(each -> each.text().equals(text))
            .findFirst()
            .orElseThrow();
    Vector3d point = panel.place().transformPosition(new Vector3d(mark.x() + 5, mark.y() - 5, 0));
    Vector3d way = point.sub(walk.world().viewer().position());
    return Optional.of(
        new XrPose(new Vector3d(), new Quaterniond().rotationTo(new Vector3d(0, 0, -1), way)));
  }

  private void choose(RunController guide, Walkthrough walk, String text) {
    Optional<XrPose> hand = at(guide, walk, text);
    guide.pointed(hand);
    guide.panels(); // It is lit before it is chosen.
    guide.pointed(hand);
    guide.answered(ControllerCommand.CHOOSE);
    guide.answered(ControllerCommand.NO); // The same button on controllers that have few.
  }

  @Test
  void whatIsPointedAtIsLitAndChosen() throws IOException {
    SessionStep asked = session.remaining().get(0);
    RunController guide = steps.next().orElseThrow().guide();
    try (Walkthrough walk = scene()) {
      guide.opened(walk);
      int dark = guide.panels().get(0).marks().size();
      guide.pointed(at(guide, walk, "Yes"));
      List<WorldSpacePanel> pointing = guide.panels();
      assertThat(pointing).hasSize(2); // The ray is one of its own.
      assertThat(pointing.get(0).marks()).hasSizeGreaterThan(dark);
      assertThat(texts(pointing.get(0))).anyMatch(text -> text.contains("press the trigger"));
      choose(guide, walk, "Yes");
      assertThat(session.answers(asked)).containsOnly(Map.entry("cube", new Answer("yes", 0)));
      choose(guide, walk, "4");
      assertThat(session.answers(asked)).containsOnly(Map.entry("cube", new Answer("yes", 4)));
      choose(guide, walk, "Back");
      choose(guide, walk, "No");
      choose(guide, walk, "2");
      assertThat(guide.over(1)).isFalse();
      choose(guide, walk, "Continue");
      assertThat(guide.over(1)).isTrue();
    }
    assertThat(session.answers(asked)).containsOnly(Map.entry("cube", new Answer("no", 2)));
  }

  @Test
  void aHandThatPointsElsewhereAnswersByItsButtons() throws IOException {
    SessionStep asked = session.remaining().get(0);
    RunController guide = steps.next().orElseThrow().guide();
    try (Walkthrough walk = scene()) {
      guide.opened(walk);
      guide.panels();
      guide.pointed(Optional.of(new XrPose(new Vector3d(), new Quaterniond().rotationY(Math.PI))));
      assertThat(guide.panels()).hasSize(2);
      guide.answered(ControllerCommand.CHOOSE);
      assertThat(session.answers(asked)).isEmpty();
      guide.answered(ControllerCommand.NO);
    }
    assertThat(session.answers(asked)).containsOnly(Map.entry("cube", new Answer("no", 0)));
  }

  @Test
  void theRayGoesFromTheHandToThePanel() throws IOException {
    RunController guide = steps.next().orElseThrow().guide();
    try (Walkthrough walk = scene()) {
      guide.opened(walk);
      guide.panels();
      guide.pointed(
          Optional.of(
              new XrPose(
                  new Vector3d(0.2, -0.4, -0.3), new Quaterniond().rotationX(0.2).rotateY(0.1))));
      WorldSpacePanel ray = guide.panels().get(1);
      double[] band = ((Primitive2D.Area) ray.marks().get(0)).corners();
      Vector3d start = ray.place().transformPosition(new Vector3d(0, 0, 0));
      Vector3d end = ray.place().transformPosition(new Vector3d(band[2], 0, 0));
      assertThat(start.distance(0.2, 1.2, -0.3)).isCloseTo(0, within(1e-6));
      assertThat(end.z).isCloseTo(-PanelPlacement.DISTANCE, within(1e-6));
    }
  }

  @Test
  void thePanelStandsBeforeTheHeadUntilHeTurnsAway() throws IOException {
    RunController guide = steps.next().orElseThrow().guide();
    try (Walkthrough walk = scene()) {
      guide.opened(walk);
      Viewer viewer = walk.world().viewer();
      Vector3d ahead = middle(guide);
      assertThat(ahead.distance(new Vector3d(0, 1.6, -PanelPlacement.DISTANCE)))
          .isCloseTo(0, within(1e-6));
      viewer.turnTo(new Quaterniond().rotationY(Math.toRadians(30)));
      assertThat(middle(guide).distance(ahead)).isCloseTo(0, within(1e-6));
      viewer.turnTo(new Quaterniond().rotationY(Math.toRadians(90)));
      assertThat(middle(guide).distance(new Vector3d(-PanelPlacement.DISTANCE, 1.6, 0)))
          .isCloseTo(0, within(1e-6));
    }
  }

  /** The middle of the paper in the world. */
  private static Vector3d middle(RunController guide) {
    WorldSpacePanel panel = guide.panels().get(0);
    double[] paper = ((Primitive2D.Area) panel.marks().get(0)).corners();
    Matrix4dc place = panel.place();
    return place.transformPosition(new Vector3d(paper[4] / 2, paper[5] / 2, 0));
  }

  @Test
  void aHeadsetThatGoesDuringAnExposureFlagsTheSession() throws IOException {
    SessionStep asked = session.remaining().get(0);
    session.began(asked, false);
    session.finished(asked, Map.of());
    RunListener exposure = steps.next().orElseThrow().listener();
    exposure.headset(new HeadsetEvent(HeadsetEvent.Kind.COVERED, "a menu is before the scene"));
    assertThat(Files.readString(session.folder().journal())).doesNotContain("headset-lost");
    exposure.headset(new HeadsetEvent(HeadsetEvent.Kind.AWAY, "nobody wears the headset"));
    assertThat(told).anyMatch(line -> line.contains("the session is flagged headset-lost"));
    session.close();
    assertThat(Files.readString(session.folder().journal()))
        .contains("\"flag\":\"headset-lost\"", "\"what\":\"away\"");
  }
}
