package org.selectiverenderer.control;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.control.ControlEvent.SwitchChange;
import org.selectiverenderer.control.SelectiveController.Settings;
import org.web3d.x3d.sai.X3DNode;
import org.web3d.x3d.sai.grouping.Switch;

/** Choices wait while the objects are looked at. */
class WaitingChoicesTest implements SwitchTiming {
  private static final SwitchVisibility UNSEEN = new SwitchVisibility(false, 0, 0);

  private final Set<String> watched = new HashSet<>();
  private ControlledSceneFixture scene;

  @Override
  public boolean mayShow(X3DNode node, int choice) {
    return watched.stream().noneMatch(name -> scene.node(name).equals(node));
  }

  @Override
  public Optional<SwitchVisibility> shows(X3DNode node, int choice) {
    return Optional.of(UNSEEN);
  }

  @BeforeEach
  void open() {
    scene =
        new ControlledSceneFixture(
            ControlledSceneFixture.area("Kitchen", 0, "kitchen", "hall")
                + ControlledSceneFixture.area("Bath", 9, "bath", "hall")
                + ControlledSceneFixture.object("DEF='Vase'", "kitchen", "hall")
                + ControlledSceneFixture.object("DEF='Lamp'", "kitchen", "hall"));
    scene.control(Settings.SELECTIVE, this);
    scene.news();
  }

  @AfterEach
  void close() {
    scene.close();
  }

  private List<SwitchChange> changes() {
    return scene.news().stream()
        .filter(SwitchChange.class::isInstance)
        .map(SwitchChange.class::cast)
        .toList();
  }

  private static SwitchChange change(double time, String name, int from, int to, String schema) {
    return new SwitchChange(time, name, from, to, schema, Optional.of(UNSEEN));
  }

  @Test
  void aChoiceWaitsUntilItMayBeShownAndIsToldThen() {
    watched.add("Vase");
    scene.walkTo(0);
    assertThat(changes()).containsExactly(change(1, "Lamp", 1, 0, "kitchen"));
    assertThat(scene.choice("Vase")).isEqualTo(1);
    assertThat(scene.controller.waiting()).containsExactly(Map.entry("Vase", 0));
    scene.controller.showDue(2);
    assertThat(changes()).isEmpty();
    watched.clear();
    scene.controller.showDue(3);
    assertThat(changes()).containsExactly(change(3, "Vase", 1, 0, "kitchen"));
    assertThat(scene.choice("Vase")).isZero();
    assertThat(scene.controller.waiting()).isEmpty();
    assertThat(scene.controller.choices()).containsEntry("Vase", 0);
  }

  @Test
  void anObjectWhoseAreaIsLeftBeforeItsTimeDoesNotChangeAtAll() {
    watched.add("Vase");
    scene.walkTo(0);
    scene.walkTo(5);
    watched.clear();
    scene.controller.showDue(3);
    assertThat(changes())
        .as("only the other one goes there and back")
        .containsExactly(change(1, "Lamp", 1, 0, "kitchen"), change(2, "Lamp", 0, 1, "hall"));
    assertThat(scene.choice("Vase")).isEqualTo(1);
  }

  @Test
  void whatWaitsIsShownInTheOrderInWhichItCame() {
    watched.addAll(Set.of("Lamp", "Vase"));
    scene.walkTo(0);
    watched.clear();
    scene.controller.showDue(2);
    assertThat(changes())
        .containsExactly(change(2, "Vase", 1, 0, "kitchen"), change(2, "Lamp", 1, 0, "kitchen"));
  }

  @Test
  void aChoiceThatOthersSetMeanwhileStays() {
    watched.add("Vase");
    scene.walkTo(0);
    ((Switch) scene.node("Vase")).setWhichChoice(-1);
    scene.walkTo(0);
    watched.clear();
    scene.controller.showDue(3);
    assertThat(scene.choice("Vase")).isEqualTo(-1);
    assertThat(scene.controller.waiting()).isEmpty();
  }

  @Test
  void aHeldChoiceIsShownAtOnceAndNothingWaitsAnyMore() {
    watched.add("Vase");
    scene.walkTo(0);
    scene.hold(Map.of("Vase", -1));
    assertThat(scene.choice("Vase")).isEqualTo(-1);
    watched.clear();
    scene.controller.showDue(2);
    assertThat(scene.choice("Vase")).isEqualTo(-1);
    assertThat(scene.controller.waiting()).isEmpty();
  }

  @Test
  void anObjectThatLeavesTheSceneWaitsNoLonger() {
    watched.add("Vase");
    scene.walkTo(0);
    scene.scene().removeRootNode(scene.node("Vase"));
    scene.walkTo(0);
    watched.clear();
    scene.controller.showDue(2);
    assertThat(changes()).noneMatch(change -> change.switchName().equals("Vase"));
    assertThat(scene.controller.waiting()).isEmpty();
  }

  @Test
  void theEndOfControlLeavesWhatWaitsAsItIs() {
    watched.add("Vase");
    scene.walkTo(0);
    scene.controller.close();
    watched.clear();
    scene.controller.showDue(2);
    assertThat(scene.choice("Vase")).isEqualTo(1);
  }
}
