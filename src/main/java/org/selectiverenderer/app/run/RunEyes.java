package org.selectiverenderer.app.run;

import java.util.Locale;
import java.util.Optional;
import org.selectiverenderer.app.figures.HeadsetFigures;
import org.selectiverenderer.app.headset.HeadsetLink;
import org.selectiverenderer.app.headset.RoomTeleport;
import org.selectiverenderer.app.timeline.TimelineEvent;
import org.selectiverenderer.app.walk.Walkthrough;
import org.selectiverenderer.openxr.HeadsetButton;
import org.selectiverenderer.openxr.HeadsetNews;
import org.selectiverenderer.runtime.World;
import org.selectiverenderer.runtime.walk.Controls;

/**
 * Whether somebody sees a run, and the headset in which that may be: what became of it, and what
 * its controllers ask for. A screen is always looked at.
 */
final class RunEyes {
  private final Optional<HeadsetLink> headset;
  private final RunGuide guide;
  private final RunListener listener;
  private boolean closed;
  private boolean begun;

  RunEyes(Optional<HeadsetLink> headset, RunGuide guide, RunListener listener) {
    this.headset = headset;
    this.guide = guide;
    this.listener = listener;
    closed = headset.isPresent();
    begun = headset.isEmpty();
  }

  /** Whether there is a headset. */
  boolean worn() {
    return headset.isPresent();
  }

  void presented(boolean seen) {
    closed = !seen;
    begun |= seen;
  }

  /** Whether nobody wears the headset, or its runtime shows something else. */
  boolean closed() {
    return closed;
  }

  /** Whether somebody has seen something: in a headset the scene begins then. */
  boolean begun() {
    return begun;
  }

  /** Whether somebody asked for straight ahead to be set anew: who leads, or who wears it. */
  boolean straightened() {
    boolean asked = guide.takeHeadingReset();
    return headset.map(worn -> worn.hands().take(HeadsetButton.RECENTRE)).orElse(false) || asked;
  }

  /**
   * Tells what became of the headset.
   *
   * @param walk of the scene, once that is there
   */
  void tell(Optional<Walkthrough> walk) {
    headset.ifPresent(
        worn -> {
          for (HeadsetNews news : worn.takeNews()) {
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
   * Does what the controllers ask for.
   *
   * @param paused whether time stands still, so that nobody is moved
   */
  void hands(Controls controls, World world, boolean paused) {
    headset.ifPresent(
        worn -> {
          worn.hands().drive(controls);
          guide.pointed(worn.hands().aim());
          worn.hands().takeAnswers().forEach(guide::answered);
          if (worn.hands().take(HeadsetButton.TELEPORT) && guide.walks() && !paused) {
            RoomTeleport.go(world);
          }
        });
  }

  /** How it went, with a headset. */
  Optional<HeadsetFigures> figures() {
    return headset.map(HeadsetLink::figures);
  }
}
