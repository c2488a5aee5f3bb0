package org.selectiverenderer.app.run;

import java.util.EnumSet;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.runtime.World;
import org.selectiverenderer.runtime.render.window.InputEvent;
import org.selectiverenderer.runtime.render.window.KeyboardKey;
import org.selectiverenderer.runtime.walk.Controls;

/**
 * Dispatches the keys and mouse events of a run's windows to the scene's sensors, to the run's
 * guide, or to the viewer's navigation.
 */
final class RunInput {
  private final RunGuide guide;
  private final WindowInput windowInput;
  private final SceneKeys sceneKeys = new SceneKeys();
  private final DragClaim drags = new DragClaim();
  private final Set<KeyboardKey> held = EnumSet.noneOf(KeyboardKey.class);

  /**
   * @param controls the navigation controls of the viewer
   */
  RunInput(Controls controls, RunGuide guide) {
    this.guide = guide;
    windowInput = new WindowInput(controls);
  }

  /** Dispatches an event of the participant's window; the scene may not be loaded yet. */
  void participant(InputEvent event, Optional<World> world) {
    if (world.isEmpty() || !claimed(event, world.get())) {
      windowInput.accept(event);
    }
    operatorKey(event, true);
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
}
