package org.selectiverenderer.app.run;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.navigation.KeyboardMouseControls;
import org.selectiverenderer.render.window.InputEvent;
import org.selectiverenderer.render.window.KeyboardKey;

/**
 * Dispatches the keys and mouse events of a run's windows to the scene's sensors, to the run's
 * guide, or to the viewer's navigation.
 */
final class InputDispatcher {
  private final RunController guide;
  private final NavigationInputAdapter windowInput;
  private final KeyDeviceDispatcher sceneKeys = new KeyDeviceDispatcher();
  private final DragArbiter drags = new DragArbiter();
  private final Set<KeyboardKey> held = EnumSet.noneOf(KeyboardKey.class);

  /**
   * @param controls the navigation controls of the viewer
   */
  InputDispatcher(KeyboardMouseControls controls, RunController guide) {
    this.guide = guide;
    windowInput = new NavigationInputAdapter(controls);
  }

  /** Dispatches an event of the participant's window; the scene may not be loaded yet. */
  void participant(InputEvent event, Optional<World> world) {
    boolean first = operatorKey(event, true);
    boolean guided =
        first
            && event instanceof InputEvent.KeyInput key
            && guide.pressed(key.key(), key.character(), key.nanos());
    if (!guided && (world.isEmpty() || !claimed(event, world.get()))) {
      windowInput.accept(event);
    }
  }

  /** Returns whether the scene consumes an event, so that it does not move the viewer. */
  private boolean claimed(InputEvent event, World world) {
    return sceneKeys.accept(event, world) || drags.takes(event, world);
  }

  /** Dispatches an event of the operator's window. */
  void operator(InputEvent event) {
    if (operatorKey(event, false)) {
      windowInput.command(event);
    }
  }

  /** Returns whether a key went down that was not down before; a held key repeats its event. */
  private boolean operatorKey(InputEvent event, boolean participants) {
    if (event instanceof InputEvent.FocusLost) {
      held.clear();
    }
    if (!(event instanceof InputEvent.KeyInput key)) {
      return false;
    }
    boolean first = key.pressed() ? held.add(key.key()) : held.remove(key.key());
    if (key.pressed() && first) {
      guide.operatorKey(key.key(), participants);
    }
    return key.pressed() && first;
  }

  /** Passes drags that the scene did not consume in its step to the navigation. */
  void decided(World world) {
    drags.decided(world, windowInput::accept);
  }

  /**
   * Decides whether a drag of the mouse goes to a drag sensor of the scene or to the viewer's
   * navigation. The decision is immediate where the pointer was over a drag sensor before the
   * press; otherwise the events wait until the scene has been stepped.
   */
  private static final class DragArbiter {
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
}
