package org.selectiverenderer.app.run;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.app.head.HeadTrackingSession;
import org.selectiverenderer.app.operator.OperatorConsole;
import org.selectiverenderer.app.operator.StatusOverlay;
import org.selectiverenderer.app.settings.RunSettings;
import org.selectiverenderer.render.FrameStatistics;
import org.selectiverenderer.render.display.OperatorPage;

/** The status text of a run: over its picture, and in the operator's window. */
final class RunStatusFormatter {
  private final RunSettings settings;
  private final HeadTrackingSession head;
  private final RunController guide;
  private final boolean headset;
  private final StatusOverlay overlay = new StatusOverlay();
  private final OperatorConsole console;

  RunStatusFormatter(
      RunSettings settings, HeadTrackingSession head, RunController guide, boolean headset) {
    this.settings = settings;
    this.head = head;
    this.guide = guide;
    this.headset = headset;
    console = new OperatorConsole(settings, head);
  }

  /** Shows or hides the overlay. */
  void toggle() {
    overlay.toggle();
  }

  void frame(FrameStatistics drawn) {
    overlay.frame(drawn);
  }

  /** Returns a sentence that the tracker is silent; empty while it is not. */
  Optional<String> alarm() {
    return head.health().stale()
        ? Optional.of(OperatorConsole.alarm(settings.tracker(), head.health()))
        : Optional.empty();
  }

  /** Returns the lines over the picture. */
  List<String> overlay(RunningSceneState scene) {
    List<String> lines = new ArrayList<>();
    // In a stereo display the participant would see it: there the operator's window says so.
    if (headset) {
      head.described().ifPresent(lines::add);
    } else if (!settings.display().presentation().stereo()) {
      alarm().ifPresent(lines::add);
    }
    boolean walked = settings.motion().path().isEmpty();
    lines.addAll(overlay.lines(scene.walk(), walked ? scene.walking().describe() : ""));
    lines.addAll(scene.walk().world().descriptions());
    return lines;
  }

  /**
   * Lays out the operator's window.
   *
   * @param scene the scene, once it is loaded
   * @param told lines of the run's guide
   */
  OperatorPage operatorPage(
      Optional<RunningSceneState> scene,
      List<String> told,
      int width,
      int height,
      int pictureWidth,
      int pictureHeight) {
    return scene
        .map(
            live ->
                console.page(
                    live.walk(),
                    overlay.interval(),
                    told,
                    guide.blind(),
                    width,
                    height,
                    pictureWidth,
                    pictureHeight))
        .orElseGet(() -> OperatorConsole.waiting(told));
  }
}
