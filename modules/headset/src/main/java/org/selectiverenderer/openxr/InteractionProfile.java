package org.selectiverenderer.openxr;

import static org.selectiverenderer.openxr.ControllerAction.BACKWARD;
import static org.selectiverenderer.openxr.ControllerAction.CHOOSE_LEFT;
import static org.selectiverenderer.openxr.ControllerAction.CHOOSE_RIGHT;
import static org.selectiverenderer.openxr.ControllerAction.FORWARD;
import static org.selectiverenderer.openxr.ControllerAction.NO;
import static org.selectiverenderer.openxr.ControllerAction.RECENTRE;
import static org.selectiverenderer.openxr.ControllerAction.TELEPORT;
import static org.selectiverenderer.openxr.ControllerAction.YES;

import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * An interaction profile with the suggested bindings of the program's actions (OpenXR 1.0, 6.4, and
 * {@code XR_EXT_hand_interaction}): the left stick or buttons walk, the right stick turns. On a
 * controller with few buttons, one button has two actions, of which only one is used at a time:
 * walking, or answering. If the button that answers also chooses, the target that the hand points
 * at decides. Hands point by {@code aim/pose} in all profiles.
 *
 * @param path path of the profile
 * @param name the controllers' name, for people
 * @param extension the extension that the profile needs; empty for none
 * @param walk input of the stick that walks; empty for none
 * @param turn input of the stick that turns, and answers more or less; empty for none
 * @param buttons inputs of each action
 */
record InteractionProfile(
    String path,
    String name,
    Optional<String> extension,
    Optional<String> walk,
    Optional<String> turn,
    Map<ControllerAction, List<String>> buttons) {
  static final String HANDS = "XR_EXT_hand_interaction";

  /** Input of a hand's aim pose, relative to the path of the hand. */
  static final String AIM = "/input/aim/pose";

  private static final String LEFT = "/user/hand/left/input/";
  private static final String RIGHT = "/user/hand/right/input/";
  private static final String START = "/interaction_profiles/";

  /** All supported profiles. */
  static final List<InteractionProfile> ALL =
      List.of(
          new InteractionProfile(
              START + "khr/simple_controller",
              "simple controller",
              Optional.empty(),
              Optional.empty(),
              Optional.empty(),
              Map.of(
                  FORWARD, both("select/click"),
                  BACKWARD, both("menu/click"),
                  YES, List.of(RIGHT + "select/click"),
                  NO, List.of(LEFT + "select/click"),
                  CHOOSE_LEFT, List.of(LEFT + "select/click"),
                  CHOOSE_RIGHT, List.of(RIGHT + "select/click"))),
          sticks(
              "valve/index_controller",
              "Index controllers",
              "thumbstick",
              "trigger/click",
              both("a/click"),
              both("b/click")),
          sticks(
              "oculus/touch_controller",
              "Touch controllers",
              "thumbstick",
              "trigger/value",
              List.of(RIGHT + "a/click", LEFT + "x/click"),
              List.of(RIGHT + "b/click", LEFT + "y/click")),
          sticks(
              "htc/vive_controller",
              "Vive controllers",
              "trackpad",
              "trigger/click",
              List.of(RIGHT + "menu/click"),
              List.of(LEFT + "menu/click")),
          sticks(
              "microsoft/motion_controller",
              "Windows Mixed Reality controllers",
              "thumbstick",
              "trigger/value",
              List.of(RIGHT + "squeeze/click"),
              List.of(LEFT + "squeeze/click")),
          new InteractionProfile(
              START + "ext/hand_interaction_ext",
              "hands",
              Optional.of(HANDS),
              Optional.empty(),
              Optional.empty(),
              Map.of(
                  FORWARD, List.of(RIGHT + "pinch_ext/value"),
                  BACKWARD, List.of(LEFT + "pinch_ext/value"),
                  YES, List.of(RIGHT + "grasp_ext/value"),
                  NO, List.of(LEFT + "grasp_ext/value"),
                  CHOOSE_LEFT, List.of(LEFT + "pinch_ext/value"),
                  CHOOSE_RIGHT, List.of(RIGHT + "pinch_ext/value"))));

  /**
   * Returns the profile of controllers with a stick or pad that can be pressed, and a trigger that
   * chooses.
   */
  private static InteractionProfile sticks(
      String path, String name, String stick, String trigger, List<String> yes, List<String> no) {
    return new InteractionProfile(
        START + path,
        name,
        Optional.empty(),
        Optional.of(LEFT + stick),
        Optional.of(RIGHT + stick),
        Map.of(
            FORWARD, List.of(RIGHT + trigger),
            BACKWARD, List.of(LEFT + trigger),
            TELEPORT, List.of(RIGHT + stick + "/click"),
            RECENTRE, List.of(LEFT + stick + "/click"),
            YES, yes,
            NO, no,
            CHOOSE_LEFT, List.of(LEFT + trigger),
            CHOOSE_RIGHT, List.of(RIGHT + trigger)));
  }

  private static List<String> both(String input) {
    return List.of(LEFT + input, RIGHT + input);
  }

  /** Returns the name of a profile's controllers, for people. */
  static String name(String path) {
    return ALL.stream()
        .filter(profile -> profile.path.equals(path))
        .map(InteractionProfile::name)
        .findFirst()
        .orElse(path.startsWith(START) ? path.substring(START.length()) : path);
  }
}
