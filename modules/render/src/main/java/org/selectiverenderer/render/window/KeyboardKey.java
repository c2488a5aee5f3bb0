package org.selectiverenderer.render.window;

import com.jogamp.newt.event.KeyEvent;
import java.util.Locale;

/** The keys of a keyboard by their labels. */
public enum KeyboardKey {
  A,
  B,
  C,
  D,
  E,
  F,
  G,
  H,
  I,
  J,
  K,
  L,
  M,
  N,
  O,
  P,
  Q,
  R,
  S,
  T,
  U,
  V,
  W,
  X,
  Y,
  Z,
  DIGIT_0,
  DIGIT_1,
  DIGIT_2,
  DIGIT_3,
  DIGIT_4,
  DIGIT_5,
  DIGIT_6,
  DIGIT_7,
  DIGIT_8,
  DIGIT_9,
  F1,
  F2,
  F3,
  F4,
  F5,
  F6,
  F7,
  F8,
  F9,
  F10,
  F11,
  F12,
  UP,
  DOWN,
  LEFT,
  RIGHT,
  PAGE_UP,
  PAGE_DOWN,
  HOME,
  END,
  INSERT,
  DELETE,
  ESCAPE,
  SPACE,
  ENTER,
  TAB,
  BACKSPACE,
  SHIFT,
  CONTROL,
  ALT,
  PLUS,
  MINUS,
  OTHER;

  /** Returns whether the key never produces a character. */
  boolean special() {
    return compareTo(F1) >= 0 && compareTo(ESCAPE) <= 0 && this != DELETE
        || this == SHIFT
        || this == CONTROL
        || this == ALT;
  }

  /**
   * Returns the name of the key in files: its lower-case letter or digit, {@code space}, {@code
   * enter}, {@code left}, {@code right}, {@code up}, {@code down}; empty for others.
   */
  public String spelling() {
    return switch (this) {
      case SPACE, ENTER, LEFT, RIGHT, UP, DOWN -> name().toLowerCase(Locale.ROOT);
      default -> letter();
    };
  }

  /** Returns the lower-case letter or digit of the key; empty for other keys. */
  String letter() {
    if (compareTo(Z) <= 0) {
      return name().toLowerCase(Locale.ROOT);
    }
    return compareTo(DIGIT_9) <= 0 ? name().substring(name().length() - 1) : "";
  }

  static KeyboardKey of(short symbol) {
    if (symbol >= KeyEvent.VK_A && symbol <= KeyEvent.VK_Z) {
      return values()[A.ordinal() + symbol - KeyEvent.VK_A];
    }
    if (symbol >= KeyEvent.VK_0 && symbol <= KeyEvent.VK_9) {
      return values()[DIGIT_0.ordinal() + symbol - KeyEvent.VK_0];
    }
    if (symbol >= KeyEvent.VK_F1 && symbol <= KeyEvent.VK_F12) {
      return values()[F1.ordinal() + symbol - KeyEvent.VK_F1];
    }
    return switch (symbol) {
      case KeyEvent.VK_UP -> UP;
      case KeyEvent.VK_DOWN -> DOWN;
      case KeyEvent.VK_LEFT -> LEFT;
      case KeyEvent.VK_RIGHT -> RIGHT;
      case KeyEvent.VK_PAGE_UP -> PAGE_UP;
      case KeyEvent.VK_PAGE_DOWN -> PAGE_DOWN;
      case KeyEvent.VK_HOME -> HOME;
      case KeyEvent.VK_END -> END;
      case KeyEvent.VK_INSERT -> INSERT;
      case KeyEvent.VK_DELETE -> DELETE;
      case KeyEvent.VK_ESCAPE -> ESCAPE;
      case KeyEvent.VK_SPACE -> SPACE;
      case KeyEvent.VK_ENTER -> ENTER;
      case KeyEvent.VK_TAB -> TAB;
      case KeyEvent.VK_BACK_SPACE -> BACKSPACE;
      case KeyEvent.VK_SHIFT -> SHIFT;
      case KeyEvent.VK_CONTROL -> CONTROL;
      case KeyEvent.VK_ALT, KeyEvent.VK_ALT_GRAPH -> ALT;
      case KeyEvent.VK_PLUS, KeyEvent.VK_ADD -> PLUS;
      case KeyEvent.VK_MINUS, KeyEvent.VK_SUBTRACT -> MINUS;
      default -> OTHER;
    };
  }
}
