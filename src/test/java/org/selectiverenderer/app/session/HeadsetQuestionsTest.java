package org.selectiverenderer.app.session;

import static org.assertj.core.api.Assertions.assertThat;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.joml.Matrix4d;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.selectiverenderer.app.headset.ControllerCommand;
import org.selectiverenderer.app.narration.SilentNarration;
import org.selectiverenderer.browser.camera.Camera;
import org.selectiverenderer.browser.camera.Primitive2D;
import org.selectiverenderer.browser.camera.WorldSpacePanel;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.hmd.HeadsetLayout;
import org.selectiverenderer.openxr.XrPose;
import org.selectiverenderer.render.TestImageRenderer;
import org.selectiverenderer.render.context.OffscreenFramebuffer;
import org.selectiverenderer.render.context.Screenshot;
import org.selectiverenderer.render.graphics2d.Graphics2dRenderer;
import org.selectiverenderer.study.session.ExperimenterControls;
import org.selectiverenderer.study.session.Session;
import org.selectiverenderer.study.session.SessionStep;
import org.selectiverenderer.testing.RequiresDisplay;
import org.selectiverenderer.walkthrough.Walkthrough;
import org.selectiverenderer.x3d.tessellate.TextMesher;

/** What an eye sees of the questions inside the headset; for the manual, too. */
@RequiresDisplay
class HeadsetQuestionsTest {
  private static final int WIDTH = 1200;
  private static final int HEIGHT = 1000;
  private static final int DARK = 0x0f1216;

  /**
   * Where the hand is in the scene, whose participant stands with his eye 1.6 m above (0, 0, 0).
   */
  private static final Vector3d HAND = new Vector3d(0.3, 1.0, -0.6);

  @TempDir private Path folder;

  private Session asking(String language) throws IOException {
    Files.writeString(
        folder.resolve("hall.x3d"),
        "<X3D version='4.0' profile='Immersive'><Scene>"
            + "<Viewpoint DEF='Here' position='0 1.6 0'/></Scene></X3D>");
    Files.writeString(
        folder.resolve("flat.json"),
        """
        {"name": "flat", "title": {"en": "The flat", "el": "Το διαμέρισμα"}, "pages": [
          {"name": "seen", "questions": [
            {"id": "which", "kind": "multiple",
             "text": {"en": "Which of these did you see in the kitchen?",
                      "el": "Ποια από αυτά είδατε στην κουζίνα;"},
             "options": [{"value": "kettle", "text": {"en": "A kettle", "el": "Έναν βραστήρα"}},
                         {"value": "coffee", "text": {"en": "A coffee machine", "el": "Μια καφετιέρα"}},
                         {"value": "bowl", "text": {"en": "A bowl of fruit", "el": "Ένα μπολ με φρούτα"}}]}]},
          {"name": "more", "questions": [
            {"id": "say", "kind": "text", "text": {"en": "What else do you remember of the kitchen?",
                                                   "el": "Τι άλλο θυμάστε από την κουζίνα;"}}]}]}
        """);
    Path study =
        Files.writeString(
            folder.resolve("study.json"),
            """
            {"name": "Flat", "conditions": ["selective"], "participants": 1, "scene": "hall.x3d",
             "language": "%s", "display": {"mode": "openxr", "questions": "headset"},
             "areas": [{"name": "hall", "viewpoint": "Here", "seconds": 1}],
             "questionnaires": [{"file": "flat.json", "when": "begin"}]}
            """
                .formatted(language));
    return StartedSession.of(study);
  }

  @ParameterizedTest
  @CsvSource({
    "en, A kettle;A coffee machine;A coffee machine, A bowl of fruit, ''",
    "el, Έναν βραστήρα;Συνέχεια;Συνέχεια;΄;ε;ν;α;Κενό;μ;π;ο;λ, τ, ένα μπολ"
  })
  void whatTheHandMeetsIsLitAndWhatWasChosenIsSeen(
      String language, String chosen, String pointed, String written) throws IOException {
    try (Session session = asking(language);
        Walkthrough walk =
            Walkthrough.open(
                folder.resolve("hall.x3d"),
                SelectiveController.Settings.SELECTIVE,
                problem -> {},
                event -> {},
                text -> {})) {
      walk.step(0, (moved, time, dt) -> {});
      HeadsetQuestionController guide =
          new HeadsetQuestionController(
              session,
              (SessionStep.Questions) session.remaining().get(0),
              new ExperimenterControls(session.journal()),
              new HeadsetLayout(1),
              true,
              SilentNarration.make());
      guide.opened(walk);
      guide.panels();
      for (String key : chosen.split(";")) {
        point(guide, walk, key);
        guide.answered(ControllerCommand.CHOOSE);
      }
      Screenshot before = drawn(guide.panels());
      point(guide, walk, pointed);
      List<WorldSpacePanel> panels = guide.panels();
      assertThat(texts(panels.get(0))).anyMatch(text -> text.startsWith(written));
      Screenshot shot = drawn(panels);
      assertThat(differing(before, shot)).as("pixels that the ray changes").isGreaterThan(1000);
      Path pictures = Files.createDirectories(Path.of("target/pictures"));
      shot.writePng(pictures.resolve("headset-questions-" + language + ".png"));
    }
  }

  private static List<String> texts(WorldSpacePanel panel) {
    return panel.marks().stream()
        .filter(Primitive2D.Text.class::isInstance)
        .map(mark -> ((Primitive2D.Text) mark).text())
        .toList();
  }

  /** Points from the hand at a text of the panel, for two frames: what is lit can be chosen. */
  private static void point(HeadsetQuestionController guide, Walkthrough walk, String text) {
    WorldSpacePanel panel = guide.panels().get(0);
    Primitive2D.Text mark =
        panel.marks().stream()
            .filter(Primitive2D.Text.class::isInstance)
            .map(Primitive2D.Text.class::cast)
            .filter(each -> each.text().equals(text))
            .findFirst()
            .orElseThrow(() -> new AssertionError(text + " is not among " + texts(panel)));
    Vector3d way =
        panel
            .place()
            .transformPosition(
                new Vector3d(mark.x() + 5 + 13 * (text.length() - 1), mark.y() - 5, 0))
            .sub(HAND);
    XrPose hand =
        new XrPose(
            new Vector3d(HAND).sub(walk.world().viewer().position()),
            new Quaterniond().rotationTo(new Vector3d(0, 0, -1), way));
    guide.pointed(Optional.of(hand));
    guide.panels();
    guide.pointed(Optional.of(hand));
  }

  private static Screenshot drawn(List<WorldSpacePanel> panels) {
    try (TestImageRenderer studio = new TestImageRenderer()) {
      GL3 gl = studio.gl();
      OffscreenFramebuffer target = new OffscreenFramebuffer(gl, WIDTH, HEIGHT, 4);
      target.bind(gl);
      gl.glClearColor((DARK >> 16) / 255f, (DARK >> 8 & 255) / 255f, (DARK & 255) / 255f, 1);
      gl.glClear(GL.GL_COLOR_BUFFER_BIT);
      Graphics2dRenderer painter = new Graphics2dRenderer(new TextMesher());
      Camera eye =
          new Camera(
              new Matrix4d().translation(0, -1.6, 0),
              new Matrix4d().setPerspective(Math.toRadians(46), (double) WIDTH / HEIGHT, 0.1, 100),
              0,
              0,
              WIDTH,
              HEIGHT);
      panels.forEach(panel -> painter.draw(gl, panel, eye));
      Screenshot shot = target.read(gl);
      painter.dispose(gl);
      target.dispose(gl);
      return shot;
    }
  }

  private static int differing(Screenshot a, Screenshot b) {
    int differing = 0;
    for (int y = 0; y < HEIGHT; y++) {
      for (int x = 0; x < WIDTH; x++) {
        differing += a.rgb(x, y) == b.rgb(x, y) ? 0 : 1;
      }
    }
    return differing;
  }
}
