package org.selectiverenderer.browser.nodes.keyboard;

import java.util.HashSet;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * KeySensor: sends each key press and release, without key repeats (X3D 4.0, 21.4.1). It uses the
 * kinds of keys whose output fields have a route or a listener.
 */
final class KeySensorNode extends KeyDeviceSensorNode {
  private final int keyPress;
  private final int keyRelease;
  private final int actionKeyPress;
  private final int actionKeyRelease;
  private final int shiftKey;
  private final int controlKey;
  private final int altKey;
  private final Set<KeyboardEvent.Key> held = new HashSet<>();

  KeySensorNode(NodeType type, @Nullable String name, SourceLocation location) {
    super(type, name, location);
    keyPress = type.indexOf("keyPress");
    keyRelease = type.indexOf("keyRelease");
    actionKeyPress = type.indexOf("actionKeyPress");
    actionKeyRelease = type.indexOf("actionKeyRelease");
    shiftKey = type.indexOf("shiftKey");
    controlKey = type.indexOf("controlKey");
    altKey = type.indexOf("altKey");
  }

  @Override
  void begin() {
    held.clear();
  }

  @Override
  boolean wants(KeyboardEvent.Key key) {
    if (key instanceof KeyboardEvent.Character) {
      return heard(keyPress) || heard(keyRelease);
    }
    return key instanceof KeyboardEvent.Action
        && (heard(actionKeyPress) || heard(actionKeyRelease));
  }

  @Override
  void type(KeyboardEvent stroke, EventCascade cascade) {
    boolean pressed = stroke.pressed();
    if (pressed ? !held.add(stroke.key()) : !held.remove(stroke.key())) {
      return; // A repeat, or a key pressed while another sensor was active.
    }
    if (stroke.key() instanceof KeyboardEvent.Character character) {
      emit(pressed ? keyPress : keyRelease, character.text(), cascade);
    } else if (stroke.key() instanceof KeyboardEvent.Action action) {
      emit(pressed ? actionKeyPress : actionKeyRelease, action.code(), cascade);
    } else if (stroke.key() instanceof KeyboardEvent.Modifier modifier) {
      emit(field(modifier), pressed, cascade);
    }
  }

  private int field(KeyboardEvent.Modifier modifier) {
    return switch (modifier) {
      case SHIFT -> shiftKey;
      case CONTROL -> controlKey;
      case ALT -> altKey;
    };
  }
}
