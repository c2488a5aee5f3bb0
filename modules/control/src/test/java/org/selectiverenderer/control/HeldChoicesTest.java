package org.selectiverenderer.control;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.control.SelectiveController.Settings;
import org.selectiverenderer.schema.Condition;

class HeldChoicesTest {
  private static final String SCENE =
      ControlledSceneFixture.area("Room", 0, "kitchen", "hall")
          + ControlledSceneFixture.object("DEF='Vase'", "kitchen", "hall")
          + ControlledSceneFixture.object("DEF='Lamp'", "kitchen", "hall")
          + "<Switch DEF='Plain' whichChoice='0'><Group/><Group/></Switch>";

  @Test
  void whatIsHeldFromTheStartFollowsNeitherConditionNorAreas() {
    try (ControlledSceneFixture scene = new ControlledSceneFixture(SCENE)) {
      scene.control(new Settings(Condition.SELECTIVE, 7, Map.of("Vase", 1, "Plain", -1)));
      assertThat(scene.choice("Plain")).as("a Switch without metadata").isEqualTo(-1);
      scene.walkTo(0);
      assertThat(scene.choice("Lamp")).isZero();
      assertThat(scene.choice("Vase")).isEqualTo(1);
      assertThat(scene.news())
          .noneMatch(
              event ->
                  event instanceof ControlEvent.SwitchChange change
                      && change.switchName().equals("Vase"));
      scene.walkTo(9);
      assertThat(scene.choice("Lamp")).isEqualTo(1);
      assertThat(scene.choice("Vase")).isEqualTo(1);
    }
  }

  @Test
  void choicesAreHeldLaterTooAndNamesThatNoSwitchHasAreReturned() {
    try (ControlledSceneFixture scene = new ControlledSceneFixture(SCENE)) {
      scene.control(new Settings(Condition.HIGH, 7));
      assertThat(scene.hold(Map.of("Vase", 0, "Cup", 1))).containsExactly("Cup");
      assertThat(scene.choice("Vase")).isZero();
      scene.walkTo(0);
      assertThat(scene.choice("Vase")).isZero();
      assertThat(scene.hold(Map.of("Vase", 1))).isEmpty();
      assertThat(scene.choice("Vase")).isEqualTo(1);
    }
  }
}
