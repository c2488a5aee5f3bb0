package org.selectiverenderer.browser.nodes.event;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.selectiverenderer.browser.TestNodes;
import org.selectiverenderer.browser.nodes.group.SwitchNode;
import org.selectiverenderer.browser.scene.Node;

class EventUtilitiesTest {
  private final TestNodes nodes = new TestNodes();

  private Node watched(String type, Object... fields) {
    return nodes.watch(nodes.node(type, fields));
  }

  @Test
  void aFilterPassesEachValueOnItsOwnOutputAndNegatesBoth() {
    Node filter = watched("BooleanFilter");
    nodes.send(filter, "set_boolean", true);
    assertThat(nodes.sent()).containsExactly("inputTrue=true", "inputNegate=false");
    nodes.send(filter, "set_boolean", false);
    assertThat(nodes.sent()).containsExactly("inputFalse=false", "inputNegate=true");
  }

  @Test
  void aToggleTurnsOverOnTrueOnlyAndCanBeSet() {
    Node toggle = watched("BooleanToggle");
    nodes.send(toggle, "set_boolean", true);
    nodes.send(toggle, "set_boolean", false);
    nodes.send(toggle, "set_boolean", true);
    nodes.send(toggle, "toggle", true);
    assertThat(nodes.sent()).containsExactly("toggle=true", "toggle=false", "toggle=true");
  }

  @Test
  void triggersAnswerWithTheirValue() {
    Node bool = watched("BooleanTrigger");
    Node number = watched("IntegerTrigger", "integerKey", 7);
    Node time = watched("TimeTrigger");
    nodes.cascade.at(3);
    nodes.send(bool, "set_triggerTime", 1.0);
    nodes.send(number, "set_boolean", true);
    nodes.send(number, "set_boolean", false);
    nodes.send(time, "set_boolean", false);
    assertThat(nodes.sent())
        .containsExactly("triggerTrue=true", "triggerValue=7", "triggerTime=3.0");
  }

  @Test
  void aProximitySensorSwitchesThroughATriggerAsInTheThesis() {
    Node sensor = nodes.node("ProximitySensor");
    Node trigger = nodes.node("IntegerTrigger", "integerKey", 1);
    SwitchNode choice = (SwitchNode) nodes.node("Switch");
    nodes.route(sensor, "isActive", trigger, "set_boolean");
    nodes.route(trigger, "triggerValue", choice, "whichChoice");
    nodes.cascade.emit(sensor, sensor.type().indexOf("isActive"), true);
    assertThat(choice.whichChoice()).isEqualTo(1);
  }

  @Test
  void aSequencerSendsTheValueOfTheKeyReachedWhenItIsAnother() {
    Node sequencer =
        watched(
            "IntegerSequencer", "key", new float[] {0, 0.5f, 1}, "keyValue", new int[] {4, 5, 6});
    for (float fraction : new float[] {-1, 0.2f, 0.5f, 0.9f, 1, 3, Float.NaN}) {
      nodes.send(sequencer, "set_fraction", fraction);
    }
    assertThat(nodes.sent())
        .containsExactly("value_changed=4", "value_changed=5", "value_changed=6");
  }

  @Test
  void nextAndPreviousStepAroundTheEnds() {
    Node sequencer =
        watched(
            "BooleanSequencer",
            "key",
            new float[] {0, 0.5f, 1},
            "keyValue",
            new boolean[] {true, false, false});
    nodes.send(sequencer, "next", true);
    nodes.send(sequencer, "previous", true);
    nodes.send(sequencer, "next", false);
    nodes.send(sequencer, "next", true);
    nodes.send(sequencer, "next", true);
    assertThat(nodes.sent())
        .containsExactly(
            "value_changed=true",
            "value_changed=false",
            "value_changed=true",
            "value_changed=false");
  }

  @Test
  void aSequencerWithoutKeysIsSilent() {
    Node sequencer = watched("IntegerSequencer");
    nodes.send(sequencer, "set_fraction", 0.5f);
    nodes.send(sequencer, "next", true);
    assertThat(nodes.sent()).isEmpty();
  }
}
