package org.selectiverenderer.browser.nodes.sensor;

import org.jspecify.annotations.Nullable;

/** The wake state of a {@link SleepableNode}, and the callback for when it wakes up. */
public final class WakeState {
  private boolean awake = true;
  private @Nullable Runnable call;

  /** Implements {@link SleepableNode#awake}. */
  public boolean awake() {
    return awake;
  }

  /** Implements {@link SleepableNode#wakeBy}. */
  public void wakeBy(@Nullable Runnable caller) {
    call = caller;
  }

  /** Wakes the node up. */
  public void rouse() {
    if (!awake) {
      awake = true;
      if (call != null) {
        call.run();
      }
    }
  }

  /** Ends an update: the node sleeps from now on unless it has more to do. */
  public void unless(boolean more) {
    awake = more;
  }
}
