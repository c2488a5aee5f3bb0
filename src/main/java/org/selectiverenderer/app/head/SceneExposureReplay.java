package org.selectiverenderer.app.head;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.selectiverenderer.app.settings.HeadLogSettings;
import org.selectiverenderer.browser.viewer.Viewer;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.schema.Condition;
import org.selectiverenderer.study.definition.Study;
import org.selectiverenderer.study.headlog.HeadLogMetadata;
import org.selectiverenderer.study.web.ExposureReplay;
import org.selectiverenderer.study.web.WebExposureLog;
import org.selectiverenderer.study.web.WebExposureLog.SceneEvent;
import org.selectiverenderer.tracker.PoseSample;
import org.selectiverenderer.walkthrough.Walkthrough;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;

/**
 * Replays exposures of other browsers in the scene itself, without a picture: what is in the middle
 * of the view and about it is found by the rays of the program's own head logs.
 */
public final class SceneExposureReplay implements ExposureReplay {
  /** Creates a replay. */
  public SceneExposureReplay() {}

  @Override
  public Replayed of(Study study, Exposure exposure) throws IOException {
    Path scene =
        exposure
            .scene()
            .orElseThrow(() -> new IOException(study.file() + ": the study names no scene"));
    Condition condition = exposure.condition();
    try (Walkthrough walk =
        Walkthrough.open(
            scene,
            new SelectiveController.Settings(condition, exposure.seed()),
            offline(study.access()),
            problem -> {}, // experiment check tells what is wrong in the scene
            event -> {},
            text -> {})) {
      walk.world().views().viewpoints().stream()
          .filter(node -> exposure.viewpoint().equals(node.name()))
          .findFirst()
          .ifPresent(walk.world().views()::goTo);
      return new Replayed(description(scene, condition, exposure, walk), seen(exposure, walk));
    }
  }

  /** Nothing is asked of the network for a replay, to which nobody has agreed. */
  private static ContentAccessPolicy offline(ContentAccessPolicy access) {
    return new ContentAccessPolicy(
        access.folders(), ContentAccessPolicy.none().network(), access.named());
  }

  private static HeadLogMetadata description(
      Path scene, Condition condition, Exposure exposure, Walkthrough walk) {
    walk.step(0, (viewer, time, dt) -> {});
    double half = Math.tan(walk.world().viewer().fieldOfView() / 2);
    double smaller = Math.min(exposure.width(), exposure.height());
    return new HeadLogMetadata(
        exposure.started().toString(),
        String.valueOf(scene.getFileName()),
        condition.spelling(),
        exposure.seed(),
        exposure.display(),
        "none",
        half * exposure.width() / smaller,
        half * exposure.height() / smaller,
        walk.world().scene().unitLength(),
        HeadLogSettings.CONE,
        false,
        SceneMapBuilder.of(walk.world().instances()));
  }

  private static List<Seen> seen(Exposure exposure, Walkthrough walk) {
    GazeTargetFinder gaze = new GazeTargetFinder(walk.world(), HeadLogSettings.CONE);
    List<Seen> seen = new ArrayList<>();
    Map<String, Integer> choices = new HashMap<>();
    List<SceneEvent> events = exposure.log().events();
    PoseSample angles = new PoseSample();
    int told = 0;
    for (WebExposureLog.Frame frame : exposure.log().frames()) {
      int before = told;
      while (told < events.size() && events.get(told).t() <= frame.t()) {
        SceneEvent event = events.get(told++);
        if (event.kind() == SceneEvent.Kind.SWITCH) {
          choices.put(event.node(), event.choice());
        }
      }
      if (told > before) {
        walk.hold(choices); // what the participant was shown, whatever would be shown here
      }
      angles.turn(frame.yaw(), frame.pitch(), frame.roll());
      walk.step(frame.t(), (viewer, time, dt) -> place(viewer, frame, angles));
      GazeTargetFinder.Found found = gaze.find();
      seen.add(
          new Seen(
              found.object(),
              found.distance(),
              found.version(),
              found.cone(),
              walk.activeSchemas()));
    }
    return seen;
  }

  private static void place(Viewer viewer, WebExposureLog.Frame frame, PoseSample angles) {
    viewer.moveTo(new Vector3d(frame.x(), frame.y(), frame.z()));
    viewer.turnTo(angles.orientation(new Quaterniond()));
  }
}
