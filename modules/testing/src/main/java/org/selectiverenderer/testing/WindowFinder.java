package org.selectiverenderer.testing;

import java.awt.Component;
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
import java.util.function.BooleanSupplier;
import javax.swing.JDialog;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;
import org.selectiverenderer.testing.robot.DisplaySettling;
import org.selectiverenderer.testing.robot.GuiRobot;

/** Windows that code under test opens by itself, and waits for on a thread of its own. */
public final class WindowFinder {
  private static final int PATIENCE = 60;
  private static final int CLICKS = 6;

  private WindowFinder() {}

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
  public static JFrame named(GuiRobot hands, String name) {
    hands.await("the window " + name, () -> shown(name).isPresent());
    DisplaySettling.awaitOpenedWindow();
    JFrame frame = GuiRobot.onEdt(() -> shown(name).orElseThrow());
    move(frame, frame.getX(), frame.getY() + (frame.getY() > 0 ? -1 : 1));
    return frame;
  }

  /**
   * Puts a window over the others, in whatever order they came: one that comes late covers what is
   * to be clicked.
   */
  private static void raise(Component within) {
    GuiRobot.onEdt(
        () -> {
          Window window =
              within instanceof Window itself ? itself : SwingUtilities.getWindowAncestor(within);
          window.toFront();
          return true;
        });
    DisplaySettling.awaitOpenedWindow();
  }

  private static Optional<JFrame> shown(String name) {
    return Arrays.stream(Window.getWindows())
        .filter(window -> window.isShowing() && name.equals(window.getName()))
        .map(JFrame.class::cast)
        .findFirst();
  }

  /**
   * Moves a window. Without a window manager AWT may believe a new window to be elsewhere, and
   * would click there; once moved it knows.
   */
  public static void move(JFrame frame, int x, int y) {
    GuiRobot.onEdt(
        () -> {
          frame.setLocation(x, y);
          return true;
        });
    raise(frame);
  }

  /**
   * Clicks until it has had its effect: a window that has just come on a busy machine may miss the
   * first click.
   */
  public static void click(GuiRobot hands, Component component, BooleanSupplier effect) {
    for (int i = 0; i < CLICKS && !GuiRobot.onEdt(effect::getAsBoolean); i++) {
      raise(component);
      hands.click(component);
      GuiRobot.has(effect);
    }
    hands.await("the effect of a click", effect);
  }

  /** Whether a dialogue is open. */
  public static boolean asking() {
    return dialog().isPresent();
  }

  /** Waits for a dialogue, answers it by a button, and waits until it has gone. */
  public static void answerDialog(GuiRobot hands, String button) {
    hands.await("the dialogue", () -> dialog().isPresent());
    DisplaySettling.awaitOpenedWindow();
    JDialog open = GuiRobot.onEdt(() -> dialog().orElseThrow());
    hands.choose(open, button);
  }

  private static Optional<JDialog> dialog() {
    return Arrays.stream(Window.getWindows())
        .filter(window -> window instanceof JDialog && window.isShowing())
        .map(JDialog.class::cast)
        .findFirst();
  }

  /** Takes away what is open, so that one failure is not the next test's, too. */
  public static void closeAll() {
    GuiRobot.onEdt(
        () -> {
          Arrays.stream(Window.getWindows()).forEach(Window::dispose);
          return true;
        });
  }

  /** Does what the close button of its frame does. */
  public static void close(Window window) {
    EventQueue.invokeLater(
        () -> window.dispatchEvent(new WindowEvent(window, WindowEvent.WINDOW_CLOSING)));
  }
}
