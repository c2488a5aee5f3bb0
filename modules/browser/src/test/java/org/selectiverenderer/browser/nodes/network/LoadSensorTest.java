package org.selectiverenderer.browser.nodes.network;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.browser.TestNodes;
import org.selectiverenderer.browser.nodes.network.LoadSensorNode.State;
import org.selectiverenderer.browser.nodes.sensor.TestFrameContext;
import org.selectiverenderer.browser.scene.Node;

class LoadSensorTest {
  private final TestNodes nodes = new TestNodes();
  private final TestFrameContext frame = new TestFrameContext();
  private final Map<Node, State> states = new HashMap<>();
  private final Node first = nodes.node("ImageTexture");
  private final Node second = nodes.node("AudioClip");
  private LoadSensorNode sensor;

  @BeforeEach
  void watchBoth() {
    sensor = sensor();
  }

  private LoadSensorNode sensor(Object... fields) {
    Object[] all = new Object[fields.length + 2];
    all[0] = "children";
    all[1] = List.of(first, second);
    System.arraycopy(fields, 0, all, 2, fields.length);
    LoadSensorNode made = (LoadSensorNode) nodes.watch(nodes.node("LoadSensor", all));
    made.asks(node -> states.getOrDefault(node, State.NONE));
    return made;
  }

  private List<String> at(double time) {
    frame.step(sensor, time, nodes.cascade);
    return nodes.sent();
  }

  private void begin(Node node) {
    states.put(node, State.LOADING);
    sensor.begins(node);
  }

  private void end(Node node, State how) {
    states.put(node, how);
    sensor.ends(node);
  }

  @Test
  void whatIsThereFromTheBeginningIsToldOnce() {
    states.put(first, State.LOADED);
    states.put(second, State.LOADED);
    assertThat(at(1)).containsExactly("progress=1.0", "isLoaded=true", "loadTime=1.0");
    assertThat(at(2)).isEmpty();
    assertThat(sensor.awake()).isFalse();
  }

  @Test
  void nothingIsToldOfNothing() {
    assertThat(at(1)).isEmpty();
    assertThat(sensor.awake()).isFalse();
  }

  @Test
  void whileFilesAreReadItIsActiveAndTellsWhichPartIsThere() {
    begin(first);
    begin(second);
    assertThat(at(1)).containsExactly("isActive=true", "progress=0.0");
    end(first, State.LOADED);
    assertThat(at(2)).containsExactly("progress=0.5");
    assertThat(at(3)).isEmpty();
    end(second, State.LOADED);
    assertThat(at(4))
        .containsExactly("progress=1.0", "isLoaded=true", "loadTime=4.0", "isActive=false");
    begin(first);
    assertThat(at(5)).containsExactly("isActive=true", "progress=0.5");
  }

  @Test
  void oneThatIsReadWithinAFrameIsToldInTwo() {
    states.put(second, State.LOADED);
    begin(first);
    end(first, State.LOADED);
    assertThat(at(1)).containsExactly("isActive=true");
    assertThat(at(2))
        .containsExactly("progress=1.0", "isLoaded=true", "loadTime=2.0", "isActive=false");
  }

  @Test
  void ifOneCannotBeReadNotAllAreLoaded() {
    begin(first);
    states.put(second, State.LOADED);
    assertThat(at(1)).containsExactly("isActive=true", "progress=0.5");
    end(first, State.FAILED);
    assertThat(at(2)).containsExactly("isLoaded=false", "isActive=false");
  }

  @Test
  void afterItsTimeItWaitsNoLonger() {
    sensor = sensor("timeOut", 5.0);
    begin(first);
    assertThat(at(1)).containsExactly("isActive=true", "progress=0.0");
    assertThat(at(5.9)).isEmpty();
    assertThat(at(6)).containsExactly("isLoaded=false", "isActive=false");
    end(first, State.LOADED);
    assertThat(at(7)).isEmpty();
  }

  @Test
  void disabledItTellsNothingAndEnabledWhatIsSoThen() {
    begin(first);
    at(1);
    nodes.send(sensor, "enabled", false);
    nodes.sent();
    assertThat(at(2)).containsExactly("isActive=false");
    end(first, State.LOADED);
    assertThat(at(3)).isEmpty();
    nodes.send(sensor, "enabled", true);
    nodes.sent();
    assertThat(at(4)).containsExactly("progress=1.0", "isLoaded=true", "loadTime=4.0");
  }
}
