package org.selectiverenderer.openxr;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.joml.Vector2d;
import org.joml.Vector3d;

/**
 * The program's actions with their bindings to controllers and eye tracker, for one connection to a
 * runtime.
 */
final class XrActionBindings {
  static final String GAZE = "XR_EXT_eye_gaze_interaction";
  private static final String GAZE_PROFILE = "/interaction_profiles/ext/eye_gaze_interaction";
  private static final String GAZE_POSE = "/user/eyes_ext/input/gaze_ext/pose";
  private static final List<String> HANDS = List.of("/user/hand/left", "/user/hand/right");

  /** Dead zone of a stick. */
  private static final double REST = 0.15;

  private final XrActionSystem inputs;
  private final long walk;
  private final long turn;
  private final Map<ControllerAction, Long> buttons = new EnumMap<>(ControllerAction.class);
  private final Optional<Long> gaze;
  private final List<Long> aims;
  private Optional<Long> gazeSpace = Optional.empty();
  private List<Long> aimSpaces = List.of();

  /**
   * @param enabled enabled extensions of the connection
   * @param eyeGaze whether the headset has an eye tracker
   */
  XrActionBindings(XrActionSystem inputs, Set<String> enabled, boolean eyeGaze) {
    this.inputs = inputs;
    walk = inputs.action("walk", "Walk", XrActionSystem.Kind.STICK);
    turn = inputs.action("turn", "Turn, or more and less", XrActionSystem.Kind.STICK);
    for (ControllerAction button : ControllerAction.values()) {
      String name = button.name().toLowerCase(Locale.ROOT);
      buttons.put(button, inputs.action(name, button.shown(), XrActionSystem.Kind.BUTTON));
    }
    gaze =
        eyeGaze
            ? Optional.of(inputs.action("gaze", "Where the eyes look", XrActionSystem.Kind.POSE))
            : Optional.empty();
    aims =
        List.of(
            inputs.action("aim_left", "Where the left hand points", XrActionSystem.Kind.POSE),
            inputs.action("aim_right", "Where the right hand points", XrActionSystem.Kind.POSE));
    InteractionProfile.ALL.stream()
        .filter(profile -> profile.extension().map(enabled::contains).orElse(true))
        .forEach(this::suggest);
    gaze.ifPresent(action -> suggest(GAZE_PROFILE, List.of(Map.entry(action, GAZE_POSE))));
  }

  private void suggest(InteractionProfile profile) {
    List<Map.Entry<Long, String>> bindings = new ArrayList<>();
    profile.walk().ifPresent(input -> bindings.add(Map.entry(walk, input)));
    profile.turn().ifPresent(input -> bindings.add(Map.entry(turn, input)));
    profile
        .buttons()
        .forEach(
            (button, all) ->
                all.forEach(input -> bindings.add(Map.entry(buttons.get(button), input))));
    for (int hand = 0; hand < aims.size(); hand++) {
      bindings.add(Map.entry(aims.get(hand), HANDS.get(hand) + InteractionProfile.AIM));
    }
    suggest(profile.path(), bindings);
  }

  private void suggest(String profile, List<Map.Entry<Long, String>> bindings) {
    try {
      inputs.suggest(profile, bindings);
    } catch (XrResultException e) {
      if (e.code() == XrResultException.INSTANCE_LOST
          || e.code() == XrResultException.RUNTIME_FAILURE) {
        throw e;
      }
      // A runtime need not support every profile.
    }
  }

  void attach(XrSession session) {
    inputs.attach(session);
    gazeSpace = gaze.map(inputs::space);
    aimSpaces = aims.stream().map(inputs::space).toList();
  }

  /** Reads the state of all actions at a time; directions are in the space of the head. */
  XrInputState read(XrSession session, long head, long time) {
    if (!inputs.sync()) {
      return XrInputState.NONE;
    }
    Vector2d walked = rested(inputs.stick(walk));
    Vector2d turned = rested(inputs.stick(turn));
    Set<ControllerAction> held = EnumSet.noneOf(ControllerAction.class);
    buttons.forEach(
        (button, action) -> {
          if (inputs.button(action)) {
            held.add(button);
          }
        });
    Optional<Vector3d> looked =
        gaze.filter(inputs::active)
            .flatMap(action -> session.tracked(gazeSpace.orElseThrow(), head, time))
            .map(pose -> pose.orientation().transform(new Vector3d(0, 0, -1)));
    return new XrInputState(
        walked.y,
        walked.x,
        turned.x,
        turned.y,
        held,
        looked,
        aim(0, session, head, time),
        aim(1, session, head, time));
  }

  private Optional<XrPose> aim(int hand, XrSession session, long head, long time) {
    return inputs.active(aims.get(hand))
        ? session.locate(aimSpaces.get(hand), head, time)
        : Optional.empty();
  }

  private static Vector2d rested(Vector2d stick) {
    return new Vector2d(rested(stick.x), rested(stick.y));
  }

  private static double rested(double value) {
    double beyond = Math.max(0, Math.abs(value) - REST) / (1 - REST);
    return Math.copySign(Math.min(1, beyond), value);
  }

  /** Describes the controllers in the hands in a sentence. */
  String held() {
    List<String> names =
        HANDS.stream()
            .flatMap(hand -> inputs.profile(hand).stream())
            .map(InteractionProfile::name)
            .distinct()
            .toList();
    return names.isEmpty()
        ? "no controllers are active"
        : "the headset's controls are " + String.join(" and ", names);
  }
}
