package org.selectiverenderer.app.run;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.apparatus.MouseButton;
import org.selectiverenderer.browser.navigation.KeyboardMouseControls;
import org.selectiverenderer.browser.navigation.NavigationKey;
import org.selectiverenderer.render.window.InputEvent;

/** Passes a window's input events to the navigation controls. */
final class NavigationInputAdapter {
  private final KeyboardMouseControls controls;
  private final Map<String, NavigationKey> keys = new HashMap<>();

  NavigationInputAdapter(KeyboardMouseControls controls) {
    this.controls = controls;
    for (NavigationKey key : NavigationKey.values()) {
      keys.put(key.name(), key);
    }
  }

  /** Handles a key press in another window than the user's: only command keys are passed on. */
  void command(InputEvent event) {
    if (event instanceof InputEvent.KeyInput input && input.pressed()) {
      Optional.ofNullable(keys.get(input.key().name())).ifPresent(controls::command);
    }
  }

  void accept(InputEvent event) {
    if (event instanceof InputEvent.KeyInput input) {
      Optional.ofNullable(keys.get(input.key().name()))
          .ifPresent(
              key -> {
                if (input.pressed()) {
                  controls.keyDown(key);
                } else {
                  controls.keyUp(key);
                }
              });
    } else if (event instanceof InputEvent.ButtonInput input) {
      button(input.button())
          .ifPresent(
              button -> {
                if (input.pressed()) {
                  controls.buttonDown(button);
                } else {
                  controls.buttonUp(button);
                }
              });
    } else if (event instanceof InputEvent.MotionInput input) {
      controls.drag(input.dx(), input.dy());
    } else if (event instanceof InputEvent.WheelInput input) {
      controls.wheel(input.notches());
    } else if (event instanceof InputEvent.FocusLost) {
      controls.releaseAll();
    }
  }

  private static Optional<MouseButton> button(int number) {
    return switch (number) {
      case 1 -> Optional.of(MouseButton.LEFT);
      case 2 -> Optional.of(MouseButton.MIDDLE);
      case 3 -> Optional.of(MouseButton.RIGHT);
      default -> Optional.empty();
    };
  }
}
