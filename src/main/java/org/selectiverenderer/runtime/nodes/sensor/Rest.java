package org.selectiverenderer.runtime.nodes.sensor;

import org.jspecify.annotations.Nullable;

/** Whether a {@link Sleeper} is awake, and who is to be told when something rouses it. */
public final class Rest {
  private boolean awake = true;
  private @Nullable Runnable call;

  /** {@link Sleeper#awake}. */
  public boolean awake() {
    return awake;
  }

  /** {@link Sleeper#wakeBy}. */
  public void wakeBy(@Nullable Runnable caller) {
    call = caller;
  }

  /** Something begins. */
  public void rouse() {
    if (!awake) {
      awake = true;
      if (call != null) {
        call.run();
      }
    }
  }

  /** A frame has been looked at: it rests from now on unless more goes on. */
  public void unless(boolean more) {
    awake = more;
  }
}
