package org.selectiverenderer.control;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.control.ControlEvent.SwitchChange;
import org.selectiverenderer.control.SelectiveController.Settings;
import org.selectiverenderer.control.budget.RenderingBudget;
import org.selectiverenderer.schema.Condition;
import org.web3d.x3d.sai.X3DNode;
import org.web3d.x3d.sai.grouping.Switch;

/** Under a budget areas tell what is consistent, and whoever keeps the budget chooses. */
class BudgetedChoicesTest implements SwitchTiming {
  private static final Settings BUDGET =
      Settings.SELECTIVE.within(RenderingBudget.of("triangles:100").orElseThrow());

  private ControlledSceneFixture scene;
  private boolean watched;

  @Override
  public boolean mayShow(X3DNode node, int choice) {
    return !watched;
  }

  @Override
  public Optional<SwitchVisibility> shows(X3DNode node, int choice) {
    return Optional.empty();
  }

  @BeforeEach
  void open() {
    scene =
        new ControlledSceneFixture(
            ControlledSceneFixture.area("Kitchen", 0, "kitchen", "hall")
                + ControlledSceneFixture.object("DEF='Vase'", "kitchen", "hall")
                + ControlledSceneFixture.object("DEF='Lamp'", "bath", "hall")
                + "<Switch DEF='Plain' whichChoice='0'><Group/><Group/></Switch>");
    scene.control(BUDGET, this);
    scene.news();
  }

  @AfterEach
  void close() {
    scene.close();
  }

  @Test
  void areasChangeNothingButTheConsistencyOfTheObjects() {
    List<ChoosableObject> objects = scene.controller.choosable();
    assertThat(objects)
        .extracting(object -> object.node())
        .containsExactly(scene.node("Vase"), scene.node("Lamp"));
    assertThat(objects).allMatch(object -> object.versions() == 2 && object.shown() == 1);
    assertThat(objects).extracting(ChoosableObject::consistency).containsExactly(1.0, 1.0);

    scene.walkTo(0);

    assertThat(scene.choice("Vase")).isEqualTo(1);
    assertThat(objects).extracting(ChoosableObject::consistency).containsExactly(0.0, 1.0);
    assertThat(scene.news()).hasSize(1).allMatch(ControlEvent.Enter.class::isInstance);
    assertThat(scene.controller.activeSchemas()).containsExactly("kitchen");
    scene.walkTo(9);
    assertThat(objects).extracting(ChoosableObject::consistency).containsExactly(1.0, 1.0);
    assertThat(scene.controller.choosable()).isSameAs(objects);
  }

  @Test
  void aChoiceIsShownAndToldWithTheBudgetAsItsCause() {
    ChoosableObject vase = scene.controller.choosable().get(0);

    scene.controller.choose(vase, 0, 3);
    scene.controller.choose(vase, 0, 4);

    assertThat(scene.choice("Vase")).isZero();
    assertThat(vase.shown()).isZero();
    assertThat(scene.news())
        .containsExactly(new SwitchChange(3, "Vase", 1, 0, ChoiceCause.BUDGET, Optional.empty()));
  }

  @Test
  void theFirstChoiceIsShownAtOnceAndLaterOnesWaitAsOthersDo() {
    watched = true;
    ChoosableObject vase = scene.controller.choosable().get(0);

    scene.controller.choose(vase, 0, 1);
    assertThat(scene.choice("Vase")).isZero();
    scene.controller.choose(vase, 1, 2);
    assertThat(scene.choice("Vase")).isZero();
    watched = false;
    scene.controller.showDue(3);

    assertThat(scene.choice("Vase")).isEqualTo(1);
  }

  @Test
  void whatIsHeldOrGoneIsNotChosen() {
    List<ChoosableObject> objects = scene.controller.choosable();
    scene.hold(Map.of("Vase", 1));
    assertThat(scene.controller.choosable()).containsExactly(objects.get(1));

    Switch lamp = (Switch) scene.node("Lamp");
    scene.scene().removeRootNode(lamp);
    scene.walkTo(7);
    assertThat(scene.controller.choosable()).isEmpty();
    scene.controller.choose(objects.get(1), 0, 5);
    assertThat(lamp.getWhichChoice()).isEqualTo(1);
  }

  @Test
  void versionsThatDifferInAnotherQualityFollowTheAreas() {
    scene.close();
    String lit =
        ControlledSceneFixture.object("DEF='Lit'", "kitchen", "hall")
            .replace(
                "<MetadataString name='consistencyType'",
                "<MetadataString name='quality' value='\"light\"'/>"
                    + "<MetadataString name='consistencyType'");
    scene =
        new ControlledSceneFixture(
            ControlledSceneFixture.area("Kitchen", 0, "kitchen", "hall") + lit);
    scene.control(BUDGET, this);

    assertThat(scene.controller.choosable()).isEmpty();
    scene.walkTo(0);
    assertThat(scene.choice("Lit")).isZero();
  }

  @Test
  void onlyTheSelectiveConditionHasABudget() {
    RenderingBudget budget = BUDGET.budget().orElseThrow();
    assertThatThrownBy(() -> new Settings(Condition.HIGH, 0).within(budget))
        .isInstanceOf(IllegalArgumentException.class);
    assertThatThrownBy(() -> Settings.OBSERVING.within(budget))
        .isInstanceOf(IllegalArgumentException.class);
  }
}
