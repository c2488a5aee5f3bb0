package org.selectiverenderer.app.run;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.nodes.keyboard.KeyboardEvent;
import org.selectiverenderer.render.window.InputEvent;
import org.selectiverenderer.render.window.KeyboardKey;

/**
 * Passes the keys typed in a window to the scene's key device sensors (KeySensor, StringSensor).
 */
final class KeyDeviceDispatcher {
  private final Map<String, KeyboardEvent.Key> special = new HashMap<>();
  private final Map<KeyboardKey, KeyboardEvent.Key> held = new LinkedHashMap<>();

  KeyDeviceDispatcher() {
    for (KeyboardEvent.Action key : KeyboardEvent.Action.values()) {
      special.put(key.name(), key);
    }
    for (KeyboardEvent.Modifier key : KeyboardEvent.Modifier.values()) {
      special.put(key.name(), key);
    }
  }

  /**
   * Passes an event to the sensors.
   *
   * @return whether it is a key press that the scene consumes
   */
  boolean accept(InputEvent event, World world) {
    if (event instanceof InputEvent.FocusLost) {
      held.values().forEach(key -> world.keys().type(new KeyboardEvent(key, false)));
      held.clear();
      return false;
    }
    if (!(event instanceof InputEvent.KeyInput input)) {
      return false;
    }
    Optional<KeyboardEvent.Key> key = key(input);
    key.ifPresent(
        known -> {
          if (input.pressed()) {
            held.put(input.key(), known);
          } else {
            held.remove(input.key());
          }
          world.keys().type(new KeyboardEvent(known, input.pressed()));
        });
    return input.pressed() && key.filter(world.keys()::takes).isPresent();
  }

  /** Returns the key as sensors know it; empty for other keys, such as Escape. */
  private Optional<KeyboardEvent.Key> key(InputEvent.KeyInput input) {
    KeyboardEvent.Key known = special.get(input.key().name());
    if (known != null) {
      return Optional.of(known);
    }
    return input.character().isEmpty()
        ? Optional.empty()
        : Optional.of(new KeyboardEvent.Character(input.character()));
  }
}
