package org.selectiverenderer.browser.nodes.keyboard;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * StringSensor: collects typed text (X3D 4.0, 21.4.2). Each character sends {@code enteredText};
 * Backspace deletes the last one unless {@code deletionAllowed} is FALSE; Enter sends the text as
 * {@code finalText} and starts anew with an empty {@code enteredText}. It uses all keys that
 * produce characters.
 */
final class StringSensorNode extends KeyDeviceSensorNode {
  /** Largest length of a line in characters, so that a stuck key does not fill the memory. */
  private static final int LONGEST = 10_000;

  private final int deletionAllowed;
  private final int enteredText;
  private final int finalText;
  private String text = "";
  private boolean control;

  StringSensorNode(NodeType type, @Nullable String name, SourceLocation location) {
    super(type, name, location);
    deletionAllowed = type.indexOf("deletionAllowed");
    enteredText = type.indexOf("enteredText");
    finalText = type.indexOf("finalText");
  }

  @Override
  void begin() {
    text = "";
    control = false;
  }

  @Override
  boolean wants(KeyboardEvent.Key key) {
    return key instanceof KeyboardEvent.Character;
  }

  @Override
  void type(KeyboardEvent stroke, EventCascade cascade) {
    if (stroke.key() == KeyboardEvent.Modifier.CONTROL) {
      control = stroke.pressed();
    } else if (stroke.key() instanceof KeyboardEvent.Character character
        && stroke.pressed()
        && !control) {
      type(character.text(), cascade);
    }
  }

  private void type(String typed, EventCascade cascade) {
    if (typed.equals(KeyboardEvent.ENTER)) {
      String line = text;
      text = "";
      emit(finalText, line, cascade);
      emit(enteredText, text, cascade);
    } else if (typed.equals(KeyboardEvent.BACKSPACE)) {
      if ((Boolean) value(deletionAllowed) && !text.isEmpty()) {
        text = text.substring(0, text.offsetByCodePoints(text.length(), -1));
        emit(enteredText, text, cascade);
      }
    } else if (!typed.codePoints().allMatch(Character::isISOControl)
        && text.length() + typed.length() <= LONGEST) {
      text += typed;
      emit(enteredText, text, cascade);
    }
  }
}
