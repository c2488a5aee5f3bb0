package org.selectiverenderer.testing.robot;

import java.awt.AWTEvent;
import java.awt.Toolkit;
import java.awt.event.AWTEventListener;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;

/**
 * Waits until what a robot does has come back from the display and been handled here. Robot's own
 * waiting for an idle queue takes seconds beside a view that keeps drawing.
 */
public final class RobotEventSync {
  /** Milliseconds for an event that may never come: it went to a window of somebody else. */
  private static final int PATIENCE = 150;

  /** Handling an event may put others into the queue: of the focus, and what they bring about. */
  private static final int ROUNDS = 3;

  private RobotEventSync() {}

  /**
   * Lets the robot do something.
   *
   * @param event the kind of event that comes of it, such as {@code KeyEvent.KEY_RELEASED}
   * @param times how often it comes
   */
  public static void of(int event, int times, Runnable robot) {
    Toolkit toolkit = Toolkit.getDefaultToolkit();
    Semaphore arrived = new Semaphore(0);
    AWTEventListener listener =
        happened -> {
          if (happened.getID() == event) {
            arrived.release();
          }
        };
    toolkit.addAWTEventListener(
        listener,
        AWTEvent.KEY_EVENT_MASK | AWTEvent.MOUSE_EVENT_MASK | AWTEvent.MOUSE_MOTION_EVENT_MASK);
    try {
      robot.run();
      // Whether all came or not: what did is handled below.
      boolean all = arrived.tryAcquire(times, PATIENCE, TimeUnit.MILLISECONDS);
      for (int round = 0; round < (all ? ROUNDS : 1); round++) {
        GuiRobot.onEdt(() -> true);
      }
    } catch (InterruptedException e) {
      throw new AssertionError(e);
    } finally {
      toolkit.removeAWTEventListener(listener);
    }
  }
}
