package org.selectiverenderer.app.session;

import java.io.IOException;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.app.headset.HeadsetLink;
import org.selectiverenderer.hmd.HeadsetShown;
import org.selectiverenderer.tracker.HeadTracker;
import org.selectiverenderer.tracker.TrackerListener;
import org.selectiverenderer.tracker.live.HandedTracker;

/**
 * The headset of a session: connected anew for each series of scenes, so that the participant may
 * take it off in between, with one tracker for all of them. Belongs to the thread that runs the
 * session.
 */
public final class SessionHeadset {
  private final HeadsetShown shown;
  private final Search search;
  private @Nullable HandedTracker tracker;
  private volatile @Nullable HeadsetLink link;

  /** Finds the headset of this computer. */
  interface Search {
    HeadsetLink find(HeadsetShown shown) throws IOException;
  }

  /** Creates the headset of a session with the settings for all its scenes. */
  public SessionHeadset(HeadsetShown shown) {
    this(shown, HeadsetLink::find);
  }

  SessionHeadset(HeadsetShown shown, Search search) {
    this.shown = shown;
    this.search = search;
  }

  /**
   * Checks that a headset is available, before the session begins.
   *
   * @return a description of the headset
   * @throws IOException with a sentence that says what is missing and what to do
   */
  public String require() throws IOException {
    try (HeadsetLink found = search.find(shown)) {
      return found.describe();
    }
  }

  /** Creates the tracker of the headset: the same for all scenes, opened once. */
  public HeadTracker tracker(TrackerListener hears) {
    HandedTracker made =
        new HandedTracker(
            hears,
            () -> {
              HeadsetLink now = link;
              return now == null ? "headset: not in use" : now.described();
            });
    tracker = made;
    return made;
  }

  /**
   * Connects for the next series of scenes.
   *
   * @throws IOException with a sentence when it is not there any more
   */
  HeadsetLink connect() throws IOException {
    HeadsetLink found = search.find(shown);
    link = found;
    found.feed(() -> tracker);
    return found;
  }
}
