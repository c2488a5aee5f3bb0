package org.selectiverenderer.app.run;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.selectiverenderer.runtime.World;
import org.selectiverenderer.runtime.render.window.InputEvent;

/**
 * Decides whether a drag of the mouse goes to a drag sensor of the scene or to the viewer's
 * navigation. The decision is immediate where the pointer was over a drag sensor before the press;
 * otherwise the events wait until the scene has been stepped.
 */
final class DragClaim {
  private static final int LEFT = 1;

  private final List<InputEvent> waiting = new ArrayList<>();

  /** Returns whether an event belongs to the scene or waits for the decision. */
  boolean takes(InputEvent event, World world) {
    boolean press =
        event instanceof InputEvent.ButtonInput button
            && button.button() == LEFT
            && button.pressed();
    if (press && world.wantsDrag()) {
      return true;
    }
    boolean pointer =
        event instanceof InputEvent.ButtonInput || event instanceof InputEvent.MotionInput;
    if (press && world.draggable() || pointer && !waiting.isEmpty()) {
      waiting.add(event);
      return true;
    }
    return false;
  }

  /**
   * Decides after a step: events that did not begin a drag in the scene go to the navigation
   * controls.
   */
  void decided(World world, Consumer<InputEvent> controls) {
    if (!waiting.isEmpty()) {
      List<InputEvent> events = List.copyOf(waiting);
      waiting.clear();
      if (!world.dragging()) {
        events.forEach(controls);
      }
    }
  }
}
