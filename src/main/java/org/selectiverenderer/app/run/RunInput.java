package org.selectiverenderer.app.run;

import java.util.EnumSet;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.runtime.World;
import org.selectiverenderer.runtime.render.window.InputEvent;
import org.selectiverenderer.runtime.render.window.KeyboardKey;
import org.selectiverenderer.runtime.walk.Controls;

/**
 * Keys and mouse of a run's windows: who hears of them, the scene, who leads the run, or the
 * viewer's legs.
 */
final class RunInput {
  private final RunGuide guide;
  private final WindowInput windowInput;
  private final SceneKeys sceneKeys = new SceneKeys();
  private final DragClaim drags = new DragClaim();
  private final Set<KeyboardKey> held = EnumSet.noneOf(KeyboardKey.class);

  /**
   * @param controls that move the viewer
   */
  RunInput(Controls controls, RunGuide guide) {
    this.guide = guide;
    windowInput = new WindowInput(controls);
  }

  /** In the participant's window; of a scene that may still be on its way. */
  void participant(InputEvent event, Optional<World> world) {
    if (world.isEmpty() || !claimed(event, world.get())) {
      windowInput.accept(event);
    }
    operatorKey(event, true);
  }

  /** Whether the scene has something of its own to do with it, so that the viewer does not move. */
  private boolean claimed(InputEvent event, World world) {
    return sceneKeys.accept(event, world) || drags.takes(event, world);
  }

  /** In the operator's window. */
  void operator(InputEvent event) {
    if (operatorKey(event, false)) {
      windowInput.command(event);
    }
  }

  /** Whether a key went down that was not down before: one that is held is told again and again. */
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

  /** The scene has been stepped: a drag that it did not want is the viewer's. */
  void decided(World world) {
    drags.decided(world, windowInput::accept);
  }
}
