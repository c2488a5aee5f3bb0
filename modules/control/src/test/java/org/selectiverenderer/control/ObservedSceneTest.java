package org.selectiverenderer.control;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.control.ControlEvent.Enter;
import org.selectiverenderer.control.ControlEvent.Exit;
import org.selectiverenderer.control.ControlEvent.Start;
import org.selectiverenderer.control.ControlEvent.SwitchChange;
import org.selectiverenderer.control.SelectiveController.Settings;

/** A scene that controls itself, as an exported one does, is only watched. */
class ObservedSceneTest {
  /** The lamp follows the desk by ROUTEs of the scene; nothing of the scene changes the vase. */
  private static final String SCENE =
      ControlledSceneFixture.area("Desk", 0, "kitchen", "hall")
          + ControlledSceneFixture.object("DEF='Vase'", "kitchen", "hall")
          + ControlledSceneFixture.object("DEF='Lamp'", "kitchen", "hall")
          + "<BooleanFilter DEF='Filter'/><IntegerTrigger DEF='In' integerKey='0'/>"
          + "<IntegerTrigger DEF='Out' integerKey='1'/>"
          + route("Desk", "isActive", "Filter", "set_boolean")
          + route("Filter", "inputTrue", "In", "set_boolean")
          + route("Filter", "inputNegate", "Out", "set_boolean")
          + route("In", "triggerValue", "Lamp", "whichChoice")
          + route("Out", "triggerValue", "Lamp", "whichChoice");

  private static String route(String from, String output, String to, String input) {
    return "<ROUTE fromNode='%s' fromField='%s' toNode='%s' toField='%s'/>"
        .formatted(from, output, to, input);
  }

  @Test
  void whatTheSceneDoesIsToldAndNothingElseIsDone() {
    try (ControlledSceneFixture scene = new ControlledSceneFixture(SCENE)) {
      scene.control(Settings.OBSERVING);
      int before = scene.choice("Vase");
      int lamp = scene.choice("Lamp");
      assertThat(scene.news())
          .singleElement()
          .isInstanceOfSatisfying(
              Start.class,
              start ->
                  assertThat(start.switches()).isEqualTo(Map.of("Vase", before, "Lamp", lamp)));

      scene.walkTo(0);
      List<ControlEvent> in = scene.news();
      assertThat(in)
          .anySatisfy(
              event ->
                  assertThat(event)
                      .isInstanceOfSatisfying(
                          Enter.class,
                          enter -> assertThat(enter.schemas()).containsExactly("kitchen")));
      assertThat(in).filteredOn(SwitchChange.class::isInstance).hasSize(1);
      assertThat(in)
          .anySatisfy(
              event ->
                  assertThat(event)
                      .isInstanceOfSatisfying(
                          SwitchChange.class,
                          change -> {
                            assertThat(change.switchName()).isEqualTo("Lamp");
                            assertThat(change.from()).isEqualTo(lamp);
                            assertThat(change.to()).isZero();
                            assertThat(change.schema()).isEmpty();
                          }));
      assertThat(in).extracting(ControlEvent::time).doesNotContain(0.0);

      scene.walkTo(9);
      assertThat(scene.news())
          .anyMatch(Exit.class::isInstance)
          .anyMatch(event -> event instanceof SwitchChange change && change.to() == 1);
      assertThat(scene.choice("Vase")).isEqualTo(before);
    }
  }
}
