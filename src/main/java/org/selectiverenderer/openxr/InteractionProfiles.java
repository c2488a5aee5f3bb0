package org.selectiverenderer.openxr;

import static org.selectiverenderer.openxr.HeadsetButton.BACKWARD;
import static org.selectiverenderer.openxr.HeadsetButton.CHOOSE_LEFT;
import static org.selectiverenderer.openxr.HeadsetButton.CHOOSE_RIGHT;
import static org.selectiverenderer.openxr.HeadsetButton.FORWARD;
import static org.selectiverenderer.openxr.HeadsetButton.NO;
import static org.selectiverenderer.openxr.HeadsetButton.RECENTRE;
import static org.selectiverenderer.openxr.HeadsetButton.TELEPORT;
import static org.selectiverenderer.openxr.HeadsetButton.YES;

import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Where the program's actions are on the controllers that it knows (OpenXR 1.0, 6.4, and {@code
 * XR_EXT_hand_interaction}): walk by the left stick or by buttons, turn by the right stick. Where a
 * controller has few buttons, one means two things, of which one is asked for at a time: walking,
 * or an answer. Where its button for an answer is the one that chooses, too, what is pointed at
 * decides. Hands point by {@code aim/pose} on all of them.
 *
 * @param path of the profile
 * @param name for people
 * @param extension that it needs; empty for none
 * @param walk input that walks by a stick; empty for none
 * @param turn input that turns by a stick, and answers more or less; empty for none
 * @param buttons inputs of each button
 */
record InteractionProfiles(
    String path,
    String name,
    Optional<String> extension,
    Optional<String> walk,
    Optional<String> turn,
    Map<HeadsetButton, List<String>> buttons) {
  static final String HANDS = "XR_EXT_hand_interaction";

  /** The input of a hand, after its own path, that says where it points. */
  static final String AIM = "/input/aim/pose";

  private static final String LEFT = "/user/hand/left/input/";
  private static final String RIGHT = "/user/hand/right/input/";
  private static final String START = "/interaction_profiles/";

  /** All that are known. */
  static final List<InteractionProfiles> ALL =
      List.of(
          new InteractionProfiles(
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
          new InteractionProfiles(
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

  /** A stick or pad in each hand, which can be pressed, and a trigger that chooses. */
  private static InteractionProfiles sticks(
      String path, String name, String stick, String trigger, List<String> yes, List<String> no) {
    return new InteractionProfiles(
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

  /** A profile's name for people. */
  static String name(String path) {
    return ALL.stream()
        .filter(profile -> profile.path.equals(path))
        .map(InteractionProfiles::name)
        .findFirst()
        .orElse(path.startsWith(START) ? path.substring(START.length()) : path);
  }
}
