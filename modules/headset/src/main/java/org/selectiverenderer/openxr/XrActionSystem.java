package org.selectiverenderer.openxr;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.joml.Vector2d;

/** The functions of OpenXR's action system. All throw {@link XrResultException}. */
interface XrActionSystem {
  /** The type of an action, with its number in OpenXR (XrActionType, OpenXR 1.0, 11.4). */
  enum Kind {
    BUTTON(1),
    STICK(3),
    POSE(4);

    private final int number;

    Kind(int number) {
      this.number = number;
    }

    int number() {
      return number;
    }
  }

  /**
   * Creates an action.
   *
   * @param name name of lower-case letters
   * @param shown localized name, which the runtime shows to users
   */
  long action(String name, String shown, Kind kind);

  /**
   * Suggests bindings of the actions for an interaction profile.
   *
   * @param bindings paths of the inputs, each with its action
   * @throws XrResultException also if the runtime does not support the profile
   */
  void suggest(String profile, List<Map.Entry<Long, String>> bindings);

  /** Attaches the action set to a session. */
  void attach(XrSession session);

  /**
   * Synchronizes the states of the actions; false while the program does not have the input focus.
   */
  boolean sync();

  boolean button(long action);

  Vector2d stick(long action);

  /** Creates the action space of a pose action. */
  long space(long action);

  /** Returns whether a pose action is active. */
  boolean active(long action);

  /** Returns the path of a hand's current interaction profile; empty for none. */
  Optional<String> profile(String hand);
}
