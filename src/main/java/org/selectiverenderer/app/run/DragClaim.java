package org.selectiverenderer.app.run;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.selectiverenderer.runtime.World;
import org.selectiverenderer.runtime.render.window.InputEvent;

/**
 * Keeps from the viewer's controls what is a drag in the scene. Whether a press begins one is known
 * where the pointer rested on a drag sensor, else only after the next step: till then it waits.
 */
final class DragClaim {
  private static final int LEFT = 1;

  private final List<InputEvent> waiting = new ArrayList<>();

  /** Whether an event is the scene's, or waits. */
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

  /** After a step: what has turned out to be no drag goes to the controls after all. */
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
