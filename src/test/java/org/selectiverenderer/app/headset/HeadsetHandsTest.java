package org.selectiverenderer.app.headset;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.openxr.HeadsetButton;
import org.selectiverenderer.openxr.SpacePose;
import org.selectiverenderer.openxr.XrInput;
import org.selectiverenderer.runtime.walk.Controls;
import org.selectiverenderer.runtime.walk.Motion;
import org.selectiverenderer.runtime.walk.MouseMapping;

class HeadsetHandsTest {
  private final Controls controls = new Controls(MouseMapping.WALK);

  private static XrInput sticks(double forward, double right, double turn, double more) {
    return new XrInput(forward, right, turn, more, Set.of(), Optional.empty());
  }

  private static XrInput held(HeadsetButton... buttons) {
    return new XrInput(0, 0, 0, 0, Set.of(buttons), Optional.empty());
  }

  private Motion drive(HeadsetHands hands, XrInput input) {
    hands.frame(input);
    hands.drive(controls);
    return controls.next(0.1);
  }

  @Test
  void sticksWalkAndTurnSmoothly() {
    Motion motion = drive(new HeadsetHands(0), sticks(0.5, -0.25, 1, 0));
    assertThat(motion.forward()).isEqualTo(0.5);
    assertThat(motion.strafe()).isEqualTo(-0.25);
    assertThat(motion.turn()).isNegative(); // To the right.
    assertThat(motion.lookYaw()).isZero();
  }

  @Test
  void aStickTurnsByOneStepForEachPush() {
    HeadsetHands hands = new HeadsetHands(Math.toRadians(30));
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
    HeadsetHands hands = new HeadsetHands(0);
    assertThat(drive(hands, held(HeadsetButton.FORWARD)).forward()).isEqualTo(1);
    assertThat(drive(hands, held(HeadsetButton.BACKWARD)).forward()).isEqualTo(-1);
    hands.rest();
    assertThat(drive(hands, held()).forward()).isZero();
  }

  @Test
  void answersAreTakenOnceForEachPress() {
    HeadsetHands hands = new HeadsetHands(0);
    hands.frame(held(HeadsetButton.YES));
    hands.frame(held(HeadsetButton.YES));
    hands.frame(held(HeadsetButton.NO));
    hands.frame(sticks(0, 0, 0, 0.8));
    hands.frame(sticks(0, 0, 0, 0.6));
    hands.frame(sticks(0, 0, 0, -0.8));
    assertThat(hands.takeAnswers())
        .isEqualTo(
            List.of(HeadsetAnswer.YES, HeadsetAnswer.NO, HeadsetAnswer.MORE, HeadsetAnswer.LESS));
    assertThat(hands.takeAnswers()).isEmpty();
  }

  @Test
  void commandsAreTakenOnceForEachPress() {
    HeadsetHands hands = new HeadsetHands(0);
    hands.frame(held(HeadsetButton.TELEPORT));
    assertThat(hands.take(HeadsetButton.TELEPORT)).isTrue();
    hands.frame(held(HeadsetButton.TELEPORT));
    assertThat(hands.take(HeadsetButton.TELEPORT)).isFalse();
  }

  private static XrInput pointing(boolean left, boolean right, HeadsetButton... buttons) {
    SpacePose leftHand = new SpacePose(new Vector3d(-1, 0, 0), new Quaterniond());
    SpacePose rightHand = new SpacePose(new Vector3d(1, 0, 0), new Quaterniond());
    return new XrInput(
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
    HeadsetHands hands = new HeadsetHands(0);
    assertThat(hands.aim()).isEmpty();
    hands.frame(pointing(true, false));
    assertThat(hands.aim().orElseThrow().position().x).isEqualTo(-1);
    hands.frame(pointing(true, true));
    assertThat(hands.aim().orElseThrow().position().x).isEqualTo(1);
    hands.frame(pointing(true, true, HeadsetButton.CHOOSE_LEFT));
    hands.frame(pointing(true, true, HeadsetButton.CHOOSE_LEFT));
    assertThat(hands.aim().orElseThrow().position().x).isEqualTo(-1);
    assertThat(hands.takeAnswers()).containsExactly(HeadsetAnswer.CHOOSE);
    hands.frame(pointing(true, true, HeadsetButton.CHOOSE_RIGHT, HeadsetButton.YES));
    assertThat(hands.aim().orElseThrow().position().x).isEqualTo(1);
    assertThat(hands.takeAnswers()).containsExactly(HeadsetAnswer.CHOOSE, HeadsetAnswer.YES);
    hands.frame(pointing(true, false));
    hands.frame(pointing(true, false, HeadsetButton.CHOOSE_RIGHT)); // A hand that nobody sees.
    assertThat(hands.takeAnswers()).isEmpty();
  }
}
