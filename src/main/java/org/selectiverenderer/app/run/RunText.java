package org.selectiverenderer.app.run;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.app.head.HeadSession;
import org.selectiverenderer.app.operator.OperatorConsole;
import org.selectiverenderer.app.operator.OverlayText;
import org.selectiverenderer.app.settings.RunSettings;
import org.selectiverenderer.runtime.render.Drawn;
import org.selectiverenderer.runtime.render.show.OperatorPage;

/** What a run says of itself: over its picture, and in the operator's window. */
final class RunText {
  private final RunSettings settings;
  private final HeadSession head;
  private final RunGuide guide;
  private final boolean headset;
  private final OverlayText overlay = new OverlayText();
  private final OperatorConsole console;

  RunText(RunSettings settings, HeadSession head, RunGuide guide, boolean headset) {
    this.settings = settings;
    this.head = head;
    this.guide = guide;
    this.headset = headset;
    console = new OperatorConsole(settings, head);
  }

  /** Shows the overlay, or no longer. */
  void toggle() {
    overlay.toggle();
  }

  void frame(Drawn drawn) {
    overlay.frame(drawn);
  }

  /** Lines over the picture. */
  List<String> overlay(LiveScene scene) {
    List<String> lines = new ArrayList<>();
    // In a display the participant would see it: there the operator's window says so.
    if (headset) {
      head.described().ifPresent(lines::add);
    } else if (!settings.display().presentation().stereo() && head.health().stale()) {
      lines.add(OperatorConsole.alarm(settings.tracker(), head.health()));
    }
    boolean walked = settings.motion().path().isEmpty();
    lines.addAll(overlay.lines(scene.walk(), walked ? scene.walking().describe() : ""));
    lines.addAll(scene.walk().world().descriptions());
    return lines;
  }

  /**
   * The operator's window.
   *
   * @param scene once it is there
   * @param told by who leads the run
   */
  OperatorPage operatorPage(
      Optional<LiveScene> scene,
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
