package org.selectiverenderer.app.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.selectiverenderer.app.narration.SilentNarration;
import org.selectiverenderer.app.run.RunListener;
import org.selectiverenderer.apparatus.DisplayMode;
import org.selectiverenderer.apparatus.DisplayProfileLoader;
import org.selectiverenderer.apparatus.EyeGeometry;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.hmd.DisplayConfiguration;
import org.selectiverenderer.study.questionnaire.Answer;
import org.selectiverenderer.study.questionnaire.Question;
import org.selectiverenderer.study.session.ExperimenterControls;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.session.Session;
import org.selectiverenderer.study.session.SessionOptions;
import org.selectiverenderer.study.session.SessionStep;
import org.selectiverenderer.tracker.TrackerOptions;
import org.selectiverenderer.walkthrough.timeline.TimelineEvent;

/** With what a step of a session is shown. */
class SessionRunProviderTest {
  private static final class Unheard implements RunListener {
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
  }

  @TempDir private Path folder;

  @ParameterizedTest
  @CsvSource({"58.5, 58.5", "'', 64"})
  void aParticipantSeesWithTheDistanceOfPupilsOfTheFormElseWithTheStudys(String typed, double seen)
      throws IOException {
    Files.writeString(
        folder.resolve("rooms.x3d"),
        "<X3D version='4.0' profile='Immersive'><Scene><Viewpoint DEF='Here'/></Scene></X3D>");
    Files.writeString(
        folder.resolve("form.json"),
        """
        {"name": "me", "pages": [{"questions": [
          {"id": "eyes", "kind": "number", "min": 40, "max": 80, "sets": "ipd",
           "optional": true, "text": "IPD"}]}]}
        """);
    Path file =
        Files.writeString(
            folder.resolve("study.json"),
            """
            {"name": "Rooms", "conditions": ["selective"], "participants": 1, "scene": "rooms.x3d",
             "form": "form.json", "display": {"mode": "side-by-side", "ipd": 64},
             "areas": [{"name": "hall", "viewpoint": "Here", "seconds": 1}]}
            """);
    LoadedStudy material = LoadedStudy.read(file, new ProblemCollector()).orElseThrow();
    try (Session session =
        Session.begin(
            material,
            "001",
            1,
            new SessionOptions(Optional.empty(), OptionalDouble.empty(), false, "test"),
            new ProblemCollector())) {
      SessionStep form = session.remaining().get(0);
      session.began(form, false);
      Question eyes = session.questionnaire(form).questions().get(0);
      session.answer(form, eyes, Answer.of(typed), OptionalLong.empty(), 1);
      session.assign("18-22");
      session.finished(form, Map.of());
      DisplayConfiguration presentation =
          new DisplayConfiguration(
              DisplayMode.SIDE_BY_SIDE,
              new EyeGeometry(DisplayProfileLoader.builtIn("proview50").orElseThrow(), 0.07),
              false);
      SessionRunProvider steps =
          new SessionRunProvider(
              session,
              new SessionDisplaySettings(
                  presentation,
                  TrackerOptions.NONE,
                  false,
                  OperatorViewSettings.DESK,
                  new Unheard()),
              new ExperimenterControls(session.journal()),
              SilentNarration.make());
      assertThat(
              steps
                  .next()
                  .orElseThrow()
                  .settings()
                  .display()
                  .presentation()
                  .geometry()
                  .interpupillaryDistance())
          .isCloseTo(seen / 1000, within(1e-12));
    }
  }
}
