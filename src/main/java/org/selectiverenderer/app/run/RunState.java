package org.selectiverenderer.app.run;

import java.util.Map;
import java.util.Set;

/** The state of a run; states only advance. */
enum RunState {
  /** The scene is being loaded; there is nothing to show. */
  LOADING,
  /** The scene is loaded and is stepped; no picture of it has been shown. */
  READY,
  /** Pictures are shown. */
  SHOWN,
  /** The last frame has been stepped, or there will be none. */
  OVER;

  private static final Map<RunState, Set<RunState>> NEXT =
      Map.of(
          LOADING, Set.of(READY, OVER),
          READY, Set.of(SHOWN, OVER),
          SHOWN, Set.of(OVER),
          OVER, Set.of(OVER)); // A run may be ended by several causes at once.

  /**
   * Checks a transition and returns the next state.
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
