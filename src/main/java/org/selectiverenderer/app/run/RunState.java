package org.selectiverenderer.app.run;

import java.util.Map;
import java.util.Set;

/** What has become of a run; it never goes back. */
enum RunState {
  /** The scene is being read; there is nothing to show. */
  LOADING,
  /** The scene is there and steps; no picture of it has been shown. */
  READY,
  /** Pictures are shown. */
  SHOWN,
  /** The last frame is stepped, or there will be none. */
  OVER;

  private static final Map<RunState, Set<RunState>> NEXT =
      Map.of(
          LOADING, Set.of(READY, OVER),
          READY, Set.of(SHOWN, OVER),
          SHOWN, Set.of(OVER),
          OVER, Set.of(OVER)); // More than one thing may end a run at once.

  /**
   * The next state.
   *
   * @throws IllegalStateException if it cannot follow this one
   */
  RunState then(RunState next) {
    if (!NEXT.getOrDefault(this, Set.of()).contains(next)) {
      throw new IllegalStateException(this + " is not followed by " + next);
    }
    return next;
  }
}
