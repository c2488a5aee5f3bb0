package org.selectiverenderer.browser.navigation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.selectiverenderer.apparatus.MouseButton;
import org.selectiverenderer.apparatus.MouseButtonMapping;

class KeyboardMouseControlsTest {
  private static final double FRAME = 1.0 / 60;
  private final KeyboardMouseControls controls = new KeyboardMouseControls(MouseButtonMapping.WALK);

  private static MotionRequest hold(KeyboardMouseControls controls, double seconds) {
    MotionRequest motion = MotionRequest.NONE;
    for (int i = 0; i < Math.round(seconds / FRAME); i++) {
      motion = controls.next(FRAME);
    }
    return motion;
  }

  @Test
  void nothingPressedIsNoMotion() {
    assertThat(controls.next(FRAME)).isEqualTo(MotionRequest.NONE);
  }

  @Test
  void theButtonsWalkAsTheMappingSays() {
    assertThat(walksBy(MouseButtonMapping.WALK, MouseButton.LEFT)).isEqualTo(1);
    assertThat(walksBy(MouseButtonMapping.WALK, MouseButton.RIGHT)).isEqualTo(-1);
    assertThat(walksBy(MouseButtonMapping.EXPERIMENT, MouseButton.LEFT)).isEqualTo(-1);
    assertThat(walksBy(MouseButtonMapping.EXPERIMENT, MouseButton.RIGHT)).isEqualTo(1);
    for (MouseButton button : MouseButton.values()) {
      assertThat(walksBy(MouseButtonMapping.OFF, button)).isZero();
    }
    assertThat(walksBy(MouseButtonMapping.WALK, MouseButton.MIDDLE)).isZero();
  }

  private static double walksBy(MouseButtonMapping mapping, MouseButton button) {
    KeyboardMouseControls controls = new KeyboardMouseControls(mapping);
    controls.buttonDown(button);
    return hold(controls, 0.3).forward();
  }

  @Test
  void aClickIsNoStep() {
    controls.buttonDown(MouseButton.LEFT);
    assertThat(hold(controls, 0.1).forward()).isZero();
    controls.buttonUp(MouseButton.LEFT);
    assertThat(hold(controls, 0.5).forward()).isZero();
  }

  @Test
  void onlyAClickWithTheLeftButtonLooksAtSomething() {
    controls.buttonDown(MouseButton.LEFT);
    hold(controls, 0.1);
    controls.buttonUp(MouseButton.LEFT);
    assertThat(controls.takeCommands()).containsExactly(NavigationCommand.LOOK_AT);
    controls.buttonDown(MouseButton.LEFT);
    hold(controls, 0.3);
    controls.buttonUp(MouseButton.LEFT);
    controls.buttonDown(MouseButton.LEFT);
    controls.drag(20, 0);
    controls.buttonUp(MouseButton.LEFT);
    controls.buttonDown(MouseButton.RIGHT);
    controls.buttonUp(MouseButton.RIGHT);
    assertThat(controls.takeCommands()).isEmpty();
  }

  @Test
  void draggingAtOnceOnlyLooks() {
    controls.buttonDown(MouseButton.LEFT);
    controls.drag(20, 10);
    MotionRequest motion = controls.next(FRAME);
    assertThat(motion.lookYaw()).isCloseTo(Math.toRadians(-5), within(1e-12));
    assertThat(motion.lookPitch()).isCloseTo(Math.toRadians(-2.5), within(1e-12));
    assertThat(hold(controls, 1).forward()).isZero();
    assertThat(controls.next(FRAME).lookYaw()).isZero();
  }

  @Test
  void whoWalksSteersByMovingTheMouse() {
    controls.buttonDown(MouseButton.LEFT);
    hold(controls, 0.2);
    controls.drag(-20, 0);
    MotionRequest motion = controls.next(FRAME);
    assertThat(motion.forward()).isEqualTo(1);
    assertThat(motion.lookYaw()).isPositive();
  }

  @Test
  void underATrackerAButtonWalksAtOnceAndTheMouseTurnsNothing() {
    controls.looking(false);
    controls.buttonDown(MouseButton.LEFT);
    controls.drag(200, 100);
    MotionRequest motion = controls.next(FRAME);
    assertThat(motion.forward()).isEqualTo(1);
    assertThat(motion.lookYaw()).isZero();
    assertThat(motion.lookPitch()).isZero();
    controls.looking(true);
    controls.drag(-20, 0);
    assertThat(controls.next(FRAME).lookYaw()).isPositive();
  }

  @Test
  void theHeadingIsResetByAKey() {
    controls.keyDown(NavigationKey.F4);
    assertThat(controls.takeCommands()).containsExactly(NavigationCommand.RESET_HEADING);
  }

  @Test
  void aTremblingHandStillWalks() {
    controls.buttonDown(MouseButton.LEFT);
    controls.drag(1, 1);
    assertThat(hold(controls, 0.2).forward()).isEqualTo(1);
  }

  @Test
  void theMouseWithoutAButtonAndTheMouseThatIsOffTurnNothing() {
    controls.drag(100, 0);
    assertThat(controls.next(FRAME).lookYaw()).isZero();
    KeyboardMouseControls off = new KeyboardMouseControls(MouseButtonMapping.OFF);
    off.buttonDown(MouseButton.MIDDLE);
    off.drag(100, 0);
    off.wheel(3);
    assertThat(off.next(FRAME)).isEqualTo(MotionRequest.NONE);
  }

  @Test
  void keysWalkTurnAndGoSideways() {
    controls.keyDown(NavigationKey.W);
    controls.keyDown(NavigationKey.UP);
    controls.keyDown(NavigationKey.A);
    controls.keyDown(NavigationKey.LEFT);
    MotionRequest motion = controls.next(FRAME);
    assertThat(motion.forward()).isEqualTo(1);
    assertThat(motion.strafe()).isEqualTo(-1);
    assertThat(motion.turn()).isPositive();
    controls.keyUp(NavigationKey.W);
    controls.keyUp(NavigationKey.UP);
    controls.keyDown(NavigationKey.DOWN);
    assertThat(controls.next(FRAME).forward()).isEqualTo(-1);
  }

  @Test
  void shiftIsFasterAndTheWheelChangesTheSpeedForGood() {
    controls.keyDown(NavigationKey.SHIFT);
    assertThat(controls.next(FRAME).speedFactor()).isEqualTo(3);
    controls.keyUp(NavigationKey.SHIFT);
    controls.wheel(1);
    assertThat(controls.next(FRAME).speedFactor()).isEqualTo(1.25);
    controls.wheel(-1000);
    assertThat(controls.next(FRAME).speedFactor()).isEqualTo(1 / 16.0);
  }

  @Test
  void aRepeatedKeyIsOneCommand() {
    controls.keyDown(NavigationKey.PAGE_DOWN);
    controls.keyDown(NavigationKey.PAGE_DOWN);
    controls.keyDown(NavigationKey.F1);
    controls.keyUp(NavigationKey.F1);
    controls.keyDown(NavigationKey.F1);
    assertThat(controls.takeCommands())
        .containsExactly(
            NavigationCommand.NEXT_VIEWPOINT,
            NavigationCommand.TOGGLE_OVERLAY,
            NavigationCommand.TOGGLE_OVERLAY);
    assertThat(controls.takeCommands()).isEmpty();
  }

  @Test
  void aWindowThatLosesTheKeyboardStopsTheWalk() {
    controls.keyDown(NavigationKey.UP);
    controls.buttonDown(MouseButton.LEFT);
    hold(controls, 1);
    controls.releaseAll();
    assertThat(controls.next(FRAME)).isEqualTo(MotionRequest.NONE);
  }
}
