package org.selectiverenderer.app.run;

import java.util.Locale;
import java.util.Optional;
import org.selectiverenderer.app.headset.HeadsetConnection;
import org.selectiverenderer.app.headset.RoomTeleport;
import org.selectiverenderer.app.metrics.HeadsetMetrics;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.navigation.KeyboardMouseControls;
import org.selectiverenderer.openxr.ControllerAction;
import org.selectiverenderer.openxr.HeadsetEvent;
import org.selectiverenderer.walkthrough.Walkthrough;
import org.selectiverenderer.walkthrough.timeline.TimelineEvent;

/**
 * The headset of a run, if any: whether its user sees the picture, its events, and the commands of
 * its controllers. Without a headset the picture counts as always seen.
 */
final class HeadsetRunState {
  private final Optional<HeadsetConnection> headset;
  private final RunController guide;
  private final RunListener listener;
  private boolean closed;
  private boolean begun;

  HeadsetRunState(Optional<HeadsetConnection> headset, RunController guide, RunListener listener) {
    this.headset = headset;
    this.guide = guide;
    this.listener = listener;
    closed = headset.isPresent();
    begun = headset.isEmpty();
  }

  /** Returns whether there is a headset. */
  boolean worn() {
    return headset.isPresent();
  }

  void presented(boolean seen) {
    closed = !seen;
    begun |= seen;
  }

  /**
   * Returns whether the picture is not seen: nobody wears the headset, or its runtime shows
   * something else.
   */
  boolean closed() {
    return closed;
  }

  /** Returns whether the picture has been seen once; in a headset the scene begins then. */
  boolean begun() {
    return begun;
  }

  /** Returns whether the guide or the user of the headset asked for a reset of the heading. */
  boolean straightened() {
    boolean asked = guide.takeHeadingReset();
    return headset.map(worn -> worn.hands().take(ControllerAction.RECENTRE)).orElse(false) || asked;
  }

  /**
   * Reports the events of the headset.
   *
   * @param walk the running scene, once it is loaded
   */
  void tell(Optional<Walkthrough> walk) {
    headset.ifPresent(
        worn -> {
          for (HeadsetEvent news : worn.takeNews()) {
            listener.headset(news);
            walk.filter(begun -> begun.frames() > 0)
                .ifPresent(
                    begun ->
                        listener.happened(
                            new TimelineEvent.Headset(
                                begun.world().time(),
                                news.kind().name().toLowerCase(Locale.ROOT))));
          }
        });
  }

  /**
   * Executes the commands of the controllers.
   *
   * @param paused whether the run is paused, so that the viewer is not moved
   */
  void hands(KeyboardMouseControls controls, World world, boolean paused) {
    headset.ifPresent(
        worn -> {
          worn.hands().drive(controls);
          guide.pointed(worn.hands().aim());
          worn.hands().takeAnswers().forEach(guide::answered);
          if (worn.hands().take(ControllerAction.TELEPORT) && guide.walks() && !paused) {
            RoomTeleport.go(world);
          }
        });
  }

  /** Returns the measurements of the headset, if there is one. */
  Optional<HeadsetMetrics> figures() {
    return headset.map(HeadsetConnection::figures);
  }
}
