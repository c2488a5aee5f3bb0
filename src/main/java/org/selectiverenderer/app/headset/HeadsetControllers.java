package org.selectiverenderer.app.headset;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.browser.navigation.KeyboardMouseControls;
import org.selectiverenderer.openxr.ControllerAction;
import org.selectiverenderer.openxr.XrInputState;
import org.selectiverenderer.openxr.XrPose;

/** Translates the input of a headset's hand controllers into navigation, commands and answers. */
public final class HeadsetControllers {
  /**
   * The deflection at which a stick counts as pressed; {@code RELEASED} is the one at which it
   * counts as released (hysteresis).
   */
  private static final double PRESSED = 0.7;

  private static final double RELEASED = 0.4;

  private final double step;
  private final List<ControllerCommand> answers = new ArrayList<>();
  private final Set<ControllerAction> pressed = EnumSet.noneOf(ControllerAction.class);
  private XrInputState now = XrInputState.NONE;
  private boolean rightPoints = true;
  private int turned;
  private int told;
  private double steps;

  /**
   * @param step angle of a snap turn in radians; 0 to turn smoothly as long as the stick is pushed
   */
  HeadsetControllers(double step) {
    this.step = step;
  }

  /** Takes the input of the frame that is due. */
  void frame(XrInputState input) {
    choose(input);
    for (ControllerAction button : input.held()) {
      if (went(input, button)) {
        pressed.add(button);
        switch (button) {
          case YES -> answers.add(ControllerCommand.YES);
          case NO -> answers.add(ControllerCommand.NO);
          default -> {
            // No answer.
          }
        }
      }
    }
    int side = pushed(input.turn(), turned);
    if (side != turned) {
      steps -= side * step;
    }
    turned = side;
    int way = pushed(input.more(), told);
    if (way != told && way != 0) {
      answers.add(way > 0 ? ControllerCommand.MORE : ControllerCommand.LESS);
    }
    told = way;
    now = input;
  }

  /** Makes the hand that pressed its button last the pointing hand. */
  private void choose(XrInputState input) {
    boolean left = went(input, ControllerAction.CHOOSE_LEFT) && input.left().isPresent();
    boolean right = went(input, ControllerAction.CHOOSE_RIGHT) && input.right().isPresent();
    if (left || right) {
      rightPoints = right;
      answers.add(ControllerCommand.CHOOSE);
    }
  }

  private boolean went(XrInputState input, ControllerAction button) {
    return input.held().contains(button) && !now.held().contains(button);
  }

  /** Returns the pose of the pointing hand in head coordinates; the hand points along -Z. */
  public Optional<XrPose> aim() {
    return rightPoints ? now.right().or(now::left) : now.left().or(now::right);
  }

  private static int pushed(double value, int before) {
    if (Math.abs(value) >= PRESSED) {
      return value > 0 ? 1 : -1;
    }
    return Math.abs(value) > RELEASED && value * before > 0 ? before : 0;
  }

  /** Releases all buttons and sticks. */
  void rest() {
    now = XrInputState.NONE;
    turned = 0;
    told = 0;
  }

  /** Passes the movement of the sticks to the navigation controls. */
  public void drive(KeyboardMouseControls controls) {
    double buttons =
        (now.held().contains(ControllerAction.FORWARD) ? 1 : 0)
            - (now.held().contains(ControllerAction.BACKWARD) ? 1 : 0);
    controls.stick(now.forward() + buttons, now.side(), step > 0 ? 0 : -now.turn());
    if (steps != 0) {
      controls.turnBy(steps);
      steps = 0;
    }
  }

  /** Returns whether a button went down since the last call. */
  public boolean take(ControllerAction button) {
    return pressed.remove(button);
  }

  /** Removes and returns the answers since the last call, in order. */
  public List<ControllerCommand> takeAnswers() {
    List<ControllerCommand> taken = List.copyOf(answers);
    answers.clear();
    return taken;
  }
}
