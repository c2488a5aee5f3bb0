package org.selectiverenderer.app.headset;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.apparatus.MouseButtonMapping;
import org.selectiverenderer.browser.navigation.KeyboardMouseControls;
import org.selectiverenderer.browser.navigation.MotionRequest;
import org.selectiverenderer.openxr.ControllerAction;
import org.selectiverenderer.openxr.XrInputState;
import org.selectiverenderer.openxr.XrPose;

class HeadsetControllersTest {
  private final KeyboardMouseControls controls = new KeyboardMouseControls(MouseButtonMapping.WALK);

  private static XrInputState sticks(double forward, double right, double turn, double more) {
    return new XrInputState(forward, right, turn, more, Set.of(), Optional.empty());
  }

  private static XrInputState held(ControllerAction... buttons) {
    return new XrInputState(0, 0, 0, 0, Set.of(buttons), Optional.empty());
  }

  private MotionRequest drive(HeadsetControllers hands, XrInputState input) {
    hands.frame(input);
    hands.drive(controls);
    return controls.next(0.1);
  }

  @Test
  void sticksWalkAndTurnSmoothly() {
    MotionRequest motion = drive(new HeadsetControllers(0), sticks(0.5, -0.25, 1, 0));
    assertThat(motion.forward()).isEqualTo(0.5);
    assertThat(motion.strafe()).isEqualTo(-0.25);
    assertThat(motion.turn()).isNegative(); // To the right.
    assertThat(motion.lookYaw()).isZero();
  }

  @Test
  void aStickTurnsByOneStepForEachPush() {
    HeadsetControllers hands = new HeadsetControllers(Math.toRadians(30));
    assertThat(drive(hands, sticks(0, 0, 0.9, 0)).lookYaw())
        .isCloseTo(Math.toRadians(-30), within(1e-12));
    assertThat(drive(hands, sticks(0, 0, 0.6, 0)).lookYaw()).isZero();
    assertThat(drive(hands, sticks(0, 0, 0.9, 0)).lookYaw()).isZero();
    assertThat(drive(hands, sticks(0, 0, 0, 0)).lookYaw()).isZero();
    assertThat(drive(hands, sticks(0, 0, -0.9, 0)).lookYaw())
        .isCloseTo(Math.toRadians(30), within(1e-12));
    assertThat(drive(hands, sticks(0, 0, 0, 0)).turn()).isZero();
  }

  @Test
  void buttonsWalkWhileTheyAreHeld() {
    HeadsetControllers hands = new HeadsetControllers(0);
    assertThat(drive(hands, held(ControllerAction.FORWARD)).forward()).isEqualTo(1);
    assertThat(drive(hands, held(ControllerAction.BACKWARD)).forward()).isEqualTo(-1);
    hands.rest();
    assertThat(drive(hands, held()).forward()).isZero();
  }

  @Test
  void answersAreTakenOnceForEachPress() {
    HeadsetControllers hands = new HeadsetControllers(0);
    hands.frame(held(ControllerAction.YES));
    hands.frame(held(ControllerAction.YES));
    hands.frame(held(ControllerAction.NO));
    hands.frame(sticks(0, 0, 0, 0.8));
    hands.frame(sticks(0, 0, 0, 0.6));
    hands.frame(sticks(0, 0, 0, -0.8));
    assertThat(hands.takeAnswers())
        .isEqualTo(
            List.of(
                ControllerCommand.YES,
                ControllerCommand.NO,
                ControllerCommand.MORE,
                ControllerCommand.LESS));
    assertThat(hands.takeAnswers()).isEmpty();
  }

  @Test
  void commandsAreTakenOnceForEachPress() {
    HeadsetControllers hands = new HeadsetControllers(0);
    hands.frame(held(ControllerAction.TELEPORT));
    assertThat(hands.take(ControllerAction.TELEPORT)).isTrue();
    hands.frame(held(ControllerAction.TELEPORT));
    assertThat(hands.take(ControllerAction.TELEPORT)).isFalse();
  }

  private static XrInputState pointing(boolean left, boolean right, ControllerAction... buttons) {
    XrPose leftHand = new XrPose(new Vector3d(-1, 0, 0), new Quaterniond());
    XrPose rightHand = new XrPose(new Vector3d(1, 0, 0), new Quaterniond());
    return new XrInputState(
        0,
        0,
        0,
        0,
        Set.of(buttons),
        Optional.empty(),
        left ? Optional.of(leftHand) : Optional.empty(),
        right ? Optional.of(rightHand) : Optional.empty());
  }

  @Test
  void theHandThatChoseLastPoints() {
    HeadsetControllers hands = new HeadsetControllers(0);
    assertThat(hands.aim()).isEmpty();
    hands.frame(pointing(true, false));
    assertThat(hands.aim().orElseThrow().position().x).isEqualTo(-1);
    hands.frame(pointing(true, true));
    assertThat(hands.aim().orElseThrow().position().x).isEqualTo(1);
    hands.frame(pointing(true, true, ControllerAction.CHOOSE_LEFT));
    hands.frame(pointing(true, true, ControllerAction.CHOOSE_LEFT));
    assertThat(hands.aim().orElseThrow().position().x).isEqualTo(-1);
    assertThat(hands.takeAnswers()).containsExactly(ControllerCommand.CHOOSE);
    hands.frame(pointing(true, true, ControllerAction.CHOOSE_RIGHT, ControllerAction.YES));
    assertThat(hands.aim().orElseThrow().position().x).isEqualTo(1);
    assertThat(hands.takeAnswers())
        .containsExactly(ControllerCommand.CHOOSE, ControllerCommand.YES);
    hands.frame(pointing(true, false));
    hands.frame(pointing(true, false, ControllerAction.CHOOSE_RIGHT)); // A hand that nobody sees.
    assertThat(hands.takeAnswers()).isEmpty();
  }
}
