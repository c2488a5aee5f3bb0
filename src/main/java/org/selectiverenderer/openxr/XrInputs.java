package org.selectiverenderer.openxr;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.joml.Vector2d;

/** The functions for what hands and eyes do. All throw {@link XrFailure}. */
interface XrInputs {
  /** What an action is: numbers of OpenXR 1.0, 11.4. */
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
   * Makes an action.
   *
   * @param name of lower-case letters
   * @param shown to users by the runtime
   */
  long action(String name, String shown, Kind kind);

  /**
   * Suggests where the actions are on a kind of controller.
   *
   * @param bindings paths of the inputs, each with its action
   * @throws XrFailure also when the runtime does not know the profile
   */
  void suggest(String profile, List<Map.Entry<Long, String>> bindings);

  /** Has a session use the actions. */
  void attach(XrSession session);

  /** Asks for the present state; false while the program does not have the input. */
  boolean sync();

  boolean button(long action);

  Vector2d stick(long action);

  /** The space of a pose's action. */
  long space(long action);

  /** Whether a pose's action has something that tells it. */
  boolean active(long action);

  /** What a hand holds, as the path of its profile; empty for nothing. */
  Optional<String> profile(String hand);
}
