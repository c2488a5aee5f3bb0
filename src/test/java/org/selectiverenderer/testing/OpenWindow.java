package org.selectiverenderer.testing;

import java.awt.EventQueue;
import java.awt.Window;
import java.awt.event.WindowEvent;
import java.util.Arrays;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import javax.swing.JFrame;
import org.selectiverenderer.enricher.driving.Hands;

/** Windows that code under test opens by itself, and waits for on a thread of its own. */
public final class OpenWindow {
  private static final int PATIENCE = 60;

  private OpenWindow() {}

  /** Starts what opens windows and waits for their answers. */
  public static <T> FutureTask<T> asking(Callable<T> ask) {
    FutureTask<T> task = new FutureTask<>(ask);
    new Thread(task, "asking").start();
    return task;
  }

  /** What it came to. */
  public static <T> T answer(FutureTask<T> asked) {
    try {
      return asked.get(PATIENCE, TimeUnit.SECONDS);
    } catch (InterruptedException | ExecutionException | TimeoutException e) {
      throw new AssertionError(e);
    }
  }

  /** Waits for the window of that name, without which it would be somebody else's. */
  public static JFrame named(Hands hands, String name) {
    hands.await("the window " + name, () -> shown(name).isPresent());
    return Hands.onEdt(() -> shown(name).orElseThrow());
  }

  private static Optional<JFrame> shown(String name) {
    return Arrays.stream(Window.getWindows())
        .filter(window -> window.isShowing() && name.equals(window.getName()))
        .map(JFrame.class::cast)
        .findFirst();
  }

  /** Does what the close button of its frame does. */
  public static void close(Window window) {
    EventQueue.invokeLater(
        () -> window.dispatchEvent(new WindowEvent(window, WindowEvent.WINDOW_CLOSING)));
  }
}
