package org.selectiverenderer.app.session;

import java.io.IOException;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.app.headset.HeadsetConnection;
import org.selectiverenderer.hmd.HeadsetViewSettings;
import org.selectiverenderer.tracker.HeadTracker;
import org.selectiverenderer.tracker.TrackerListener;
import org.selectiverenderer.tracker.pipeline.HeadsetPoseTracker;

/**
 * The headset of a session: connected anew for each series of scenes, so that the participant may
 * take it off in between, with one tracker for all of them. Belongs to the thread that runs the
 * session.
 */
public final class SessionHeadset {
  private final HeadsetViewSettings shown;
  private final Search search;
  private @Nullable HeadsetPoseTracker tracker;
  private volatile @Nullable HeadsetConnection link;

  /** Finds the headset of this computer. */
  interface Search {
    HeadsetConnection find(HeadsetViewSettings shown) throws IOException;
  }

  /** Creates the headset of a session with the settings for all its scenes. */
  public SessionHeadset(HeadsetViewSettings shown) {
    this(shown, HeadsetConnection::find);
  }

  SessionHeadset(HeadsetViewSettings shown, Search search) {
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
    try (HeadsetConnection found = search.find(shown)) {
      return found.describe();
    }
  }

  /** Creates the tracker of the headset: the same for all scenes, opened once. */
  public HeadTracker tracker(TrackerListener hears) {
    HeadsetPoseTracker made =
        new HeadsetPoseTracker(
            hears,
            () -> {
              HeadsetConnection now = link;
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
  HeadsetConnection connect() throws IOException {
    HeadsetConnection found = search.find(shown);
    link = found;
    found.feed(() -> tracker);
    return found;
  }
}
