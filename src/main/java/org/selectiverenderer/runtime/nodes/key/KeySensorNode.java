package org.selectiverenderer.runtime.nodes.key;

import java.util.HashSet;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.runtime.scene.Cascade;
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
  private final Set<KeyStroke.Key> held = new HashSet<>();

  KeySensorNode(NodeType type, @Nullable String name, Location location) {
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
  boolean wants(KeyStroke.Key key) {
    if (key instanceof KeyStroke.Character) {
      return heard(keyPress) || heard(keyRelease);
    }
    return key instanceof KeyStroke.Action && (heard(actionKeyPress) || heard(actionKeyRelease));
  }

  @Override
  void type(KeyStroke stroke, Cascade cascade) {
    boolean pressed = stroke.pressed();
    if (pressed ? !held.add(stroke.key()) : !held.remove(stroke.key())) {
      return; // A repeat, or a key pressed while another sensor was active.
    }
    if (stroke.key() instanceof KeyStroke.Character character) {
      emit(pressed ? keyPress : keyRelease, character.text(), cascade);
    } else if (stroke.key() instanceof KeyStroke.Action action) {
      emit(pressed ? actionKeyPress : actionKeyRelease, action.code(), cascade);
    } else if (stroke.key() instanceof KeyStroke.Modifier modifier) {
      emit(field(modifier), pressed, cascade);
    }
  }

  private int field(KeyStroke.Modifier modifier) {
    return switch (modifier) {
      case SHIFT -> shiftKey;
      case CONTROL -> controlKey;
      case ALT -> altKey;
    };
  }
}
