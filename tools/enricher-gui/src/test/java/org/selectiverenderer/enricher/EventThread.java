package org.selectiverenderer.enricher;

import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Supplier;
import javax.swing.SwingUtilities;

/** Does things on the event dispatch thread and waits for them. */
public final class EventThread {
  private EventThread() {}

  public static void edt(Runnable task) {
    try {
      SwingUtilities.invokeAndWait(task);
    } catch (ReflectiveOperationException e) {
      throw new AssertionError(e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new AssertionError(e);
    }
  }

  public static <T> T get(Supplier<T> what) {
    AtomicReference<T> result = new AtomicReference<>();
    edt(() -> result.set(what.get()));
    return result.get();
  }
}
