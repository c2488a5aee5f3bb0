package org.selectiverenderer.browser.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.browser.TestNodes;

class EventCascadeTest {
  private final TestNodes nodes = new TestNodes();

  private Node toggle(String name) {
    return nodes.watch(nodes.named(name, "BooleanToggle"), "toggle");
  }

  @Test
  void fanOutReachesEveryEndInTheOrderOfTheRoutes() {
    Node a = toggle("a");
    Node b = toggle("b");
    Node c = toggle("c");
    nodes.route(a, "toggle", c, "toggle");
    nodes.route(a, "toggle", b, "toggle");
    nodes.send(a, "toggle", true);
    assertThat(nodes.sent()).containsExactly("a.toggle=true", "c.toggle=true", "b.toggle=true");
  }

  @Test
  void aRouteThatIsRemovedCarriesNoMore() {
    Node a = toggle("a");
    Node b = toggle("b");
    Scene scene = new Scene(nodes.group(), "", "4.0", "Full", Map.of(), 1);
    int field = a.type().indexOf("toggle");
    scene.addRoute(new Route(a, field, b, field));
    scene.addRoute(new Route(a, field, b, field));
    assertThat(scene.routes()).hasSize(1);
    scene.removeRoute(scene.routes().get(0));
    nodes.send(a, "toggle", true);
    assertThat(nodes.sent()).containsExactly("a.toggle=true");
  }

  @Test
  void manyRoutesAndListenersKeepTheirOrderWhenSomeAreRemoved() {
    Node a = toggle("a");
    Scene scene = new Scene(nodes.group(), "", "4.0", "Full", Map.of(), 1);
    int field = a.type().indexOf("toggle");
    List<String> heard = new ArrayList<>();
    List<FieldListener> listeners = new ArrayList<>();
    for (int i = 0; i < 5; i++) {
      String name = "b" + i;
      scene.addRoute(new Route(a, field, toggle(name), field));
      listeners.add((node, index, value, time) -> heard.add(name));
      a.addListener(field, listeners.get(i));
    }
    for (int i : new int[] {4, 1}) {
      scene.removeRoute(scene.routes().get(i));
      a.removeListener(field, listeners.get(i));
    }
    scene.addRoute(new Route(a, field, toggle("c"), field));
    nodes.send(a, "toggle", true);
    assertThat(nodes.sent())
        .containsExactly(
            "a.toggle=true", "b0.toggle=true", "b2.toggle=true", "b3.toggle=true", "c.toggle=true");
    assertThat(heard).containsExactly("b0", "b2", "b3");
  }

  @Test
  void aLoopEndsWhereAFieldWouldSendAgain() {
    Node a = toggle("a");
    Node b = toggle("b");
    nodes.route(a, "toggle", b, "toggle");
    nodes.route(b, "toggle", a, "toggle");
    nodes.send(a, "toggle", true);
    assertThat(nodes.sent()).containsExactly("a.toggle=true", "b.toggle=true");
  }

  @Test
  void aLoopThatNegatesEndsAndKeepsWhatWasSent() {
    Node a = toggle("a");
    Node not = nodes.node("BooleanFilter");
    nodes.route(a, "toggle", not, "set_boolean");
    nodes.route(not, "inputNegate", a, "toggle");
    nodes.send(a, "toggle", true);
    assertThat(nodes.sent()).containsExactly("a.toggle=true");
    assertThat(a.bool("toggle")).isTrue();
  }

  @Test
  void twoFirstEventsBeforeTheListenersRunDoNotKeepALoopAlive() {
    Node a = toggle("a");
    Node b = toggle("b");
    nodes.route(a, "toggle", b, "toggle");
    nodes.route(b, "toggle", a, "toggle");
    int field = a.type().indexOf("toggle");
    nodes.cascade.send(a, field, true);
    nodes.cascade.send(a, field, false);
    assertThat(nodes.sent())
        .containsExactly("a.toggle=true", "b.toggle=true", "a.toggle=false", "b.toggle=false");
  }

  @Test
  void theLastOfSeveralFirstEventsWins() {
    Node source = toggle("source");
    Node end = toggle("end");
    nodes.route(source, "toggle", end, "toggle");
    int field = end.type().indexOf("toggle");
    nodes.cascade.send(source, field, true);
    nodes.cascade.send(end, field, false);
    nodes.cascade.run();
    assertThat(end.bool("toggle")).isFalse();
  }

  @Test
  void whereRoutesMeetAgainTheFirstArrivalCounts() {
    Node a = toggle("a");
    Node not = nodes.node("BooleanFilter");
    Node end = toggle("end");
    nodes.route(a, "toggle", end, "toggle");
    nodes.route(a, "toggle", not, "set_boolean");
    nodes.route(not, "inputNegate", end, "toggle");
    nodes.send(a, "toggle", true);
    assertThat(nodes.sent()).containsExactly("a.toggle=true", "end.toggle=true");
    assertThat(end.bool("toggle")).isTrue();
  }

  @Test
  void differentSourcesMayFeedOneField() {
    Node a = toggle("a");
    Node b = toggle("b");
    Node end = toggle("end");
    nodes.route(a, "toggle", end, "toggle");
    nodes.route(b, "toggle", end, "toggle");
    nodes.send(a, "toggle", true);
    nodes.send(b, "toggle", false);
    assertThat(nodes.sent()).endsWith("b.toggle=false", "end.toggle=false");
  }

  @Test
  void allEventsOfACascadeCarryItsTime() {
    Node a = nodes.node("BooleanToggle");
    Node b = nodes.node("BooleanToggle");
    nodes.route(a, "toggle", b, "toggle");
    List<Double> times = new ArrayList<>();
    int field = a.type().indexOf("toggle");
    a.addListener(field, (node, index, value, time) -> times.add(time));
    b.addListener(field, (node, index, value, time) -> times.add(time));
    nodes.cascade.at(42.5);
    nodes.send(a, "toggle", true);
    assertThat(times).containsExactly(42.5, 42.5);
  }

  @Test
  void listenersAreCalledWhenTheValuesHaveArrivedEverywhere() {
    Node a = nodes.node("BooleanToggle");
    Node b = nodes.node("BooleanToggle");
    nodes.route(a, "toggle", b, "toggle");
    List<Boolean> seen = new ArrayList<>();
    int field = a.type().indexOf("toggle");
    a.addListener(field, (node, index, value, time) -> seen.add(b.bool("toggle")));
    nodes.send(a, "toggle", true);
    assertThat(seen).containsExactly(true);
  }

  @Test
  void aListenerThatFailsIsReportedAndSilencesNoOther() {
    Node a = nodes.node("BooleanToggle");
    int field = a.type().indexOf("toggle");
    a.addListener(
        field,
        (node, index, value, time) -> {
          throw new IllegalStateException("out of luck");
        });
    nodes.watch(a, "toggle");
    nodes.send(a, "toggle", true);
    assertThat(nodes.sent()).containsExactly("toggle=true");
    assertThat(nodes.problems.list())
        .extracting(Problem::message)
        .containsExactly("a listener of toggle failed and was skipped: out of luck");
  }

  @Test
  void aListenerThatSetsAFieldBeginsAFurtherCascadeAtTheSameTime() {
    Node a = toggle("a");
    Node b = toggle("b");
    List<Double> times = new ArrayList<>();
    int field = a.type().indexOf("toggle");
    a.addListener(field, (node, index, value, time) -> nodes.cascade.send(b, field, value));
    b.addListener(field, (node, index, value, time) -> times.add(time));
    nodes.cascade.at(7);
    nodes.send(a, "toggle", true);
    assertThat(nodes.sent()).containsExactly("a.toggle=true", "b.toggle=true");
    assertThat(times).containsExactly(7.0);
  }

  @Test
  void aListenerMayAnswerOnTheFieldThatCalledIt() {
    Node a = nodes.node("IntegerTrigger", "integerKey", 0);
    int field = a.type().indexOf("integerKey");
    a.addListener(
        field,
        (node, index, value, time) -> {
          if ((Integer) value < 5) {
            nodes.cascade.send(a, field, (Integer) value + 1);
          }
        });
    nodes.send(a, "integerKey", 1);
    assertThat(a.integer("integerKey")).isEqualTo(5);
  }

  @Test
  void listenersThatAnswerEachOtherWithoutEndAreStoppedAndReported() {
    Node a = nodes.node("IntegerTrigger");
    int field = a.type().indexOf("integerKey");
    a.addListener(field, (node, index, value, time) -> nodes.cascade.send(a, field, value));
    nodes.send(a, "integerKey", 1);
    assertThat(nodes.problems.list())
        .extracting(Problem::message)
        .containsExactly("listeners trigger each other endlessly; events were dropped");
    nodes.watch(a, "integerKey");
    nodes.cascade.run();
    assertThat(nodes.events).isEmpty();
  }

  @Test
  void anInputOnlyFieldOfAPlainNodeSendsNothing() {
    Node sensor = nodes.watch(nodes.node("CollisionSensor"));
    nodes.cascade.send(sensor, sensor.type().indexOf("isActive"), true);
    assertThat(nodes.sent()).isEmpty();
  }

  @Test
  void observersHearBeforeListeners() {
    Node a = nodes.node("BooleanToggle");
    int field = a.type().indexOf("toggle");
    List<String> order = new ArrayList<>();
    a.addListener(field, (node, index, value, time) -> order.add("listener"));
    a.addObserver((node, index) -> order.add("observer sees " + node.bool("toggle")));
    nodes.send(a, "toggle", true);
    assertThat(order).containsExactly("observer sees true", "listener");
  }

  @Test
  void aSecondCascadeOverTheSameNodesStartsAfresh() {
    Node a = nodes.watch(nodes.node("BooleanToggle"), "toggle");
    int field = a.type().indexOf("toggle");
    nodes.cascade.send(a, field, true);
    EventCascade other = new EventCascade(nodes.problems);
    other.send(a, field, false);
    assertThat(a.bool("toggle")).isFalse();
  }

  @Test
  void aNodeWithTwoNamesKeepsTheOtherWhenOneIsFreed() {
    Scene scene = new Scene(nodes.group(), "", "4.0", "Full", Map.of(), 1);
    Node a = nodes.node("Group");
    scene.name("first", a);
    scene.name("second", a);
    scene.unname("first");
    assertThat(a.name()).isEqualTo("second");
    assertThat(scene.find("first")).isEmpty();
    assertThat(scene.find("second")).containsSame(a);
  }
}
