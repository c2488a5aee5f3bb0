package org.selectiverenderer.browser.instance;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.browser.TestNodes;
import org.selectiverenderer.browser.nodes.group.GroupingNode;
import org.selectiverenderer.browser.scene.Node;

class PointingSensorDispatcherTest {
  private final TestNodes nodes = new TestNodes();
  private final PointingSensorDispatcher dispatch = new PointingSensorDispatcher();
  private InstanceTree tree;

  private Node sensor(String name) {
    return nodes.watch(nodes.named(name, "TouchSensor"), "isOver", "isActive", "touchTime");
  }

  private Node shape() {
    return nodes.node("Shape", "geometry", nodes.node("Box"));
  }

  private void scene(Node... children) {
    tree = new InstanceTree((GroupingNode) nodes.group(children), new CountingAssetProvider());
  }

  private List<Node> sensorsOf(int shape) {
    return PointingSensorDispatcher.sensors(tree.shapes().get(shape)).stream()
        .map(Instance::node)
        .toList();
  }

  private void point(int shape, boolean pressed) {
    dispatch.point(
        Optional.of(
            new PointingSensorDispatcher.Hit(
                tree.shapes().get(shape), new Vector3d(4, 0, 0), new Vector3d(0, 1, 0), 0, 0)),
        Optional.empty(),
        pressed,
        nodes.cascade);
  }

  @Test
  void allSensorsOfTheLowestGroupThatHasAnyAreMeant() {
    Node top = sensor("top");
    Node low = sensor("low");
    Node twin = sensor("twin");
    scene(top, shape(), nodes.group(nodes.group(shape()), low, twin));
    assertThat(sensorsOf(0)).containsExactly(top);
    assertThat(sensorsOf(1)).containsExactly(low, twin);
  }

  @Test
  void disabledSensorsLetThoseAboveThrough() {
    Node top = sensor("top");
    Node low = nodes.node("TouchSensor", "enabled", false);
    scene(top, nodes.group(shape(), low));
    assertThat(sensorsOf(0)).containsExactly(top);
  }

  @Test
  void anAnchorTakesTheClickUnlessASensorStandsBelow() {
    Node top = sensor("top");
    Node low = sensor("low");
    Node anchor = nodes.node("Anchor", "children", List.of(shape(), nodes.group(shape(), low)));
    scene(top, anchor);
    assertThat(sensorsOf(0)).isEmpty();
    assertThat(PointingSensorDispatcher.anchor(tree.shapes().get(0)).orElseThrow().node())
        .isSameAs(anchor);
    assertThat(sensorsOf(1)).containsExactly(low);
    assertThat(PointingSensorDispatcher.anchor(tree.shapes().get(1))).isEmpty();
  }

  @Test
  void whileTheButtonIsHeldOnlyWhereItWentDownHearsOfThePointer() {
    scene(nodes.group(shape(), sensor("a")), nodes.group(shape(), sensor("b")));
    point(0, false);
    point(0, true);
    point(1, true);
    assertThat(nodes.sent()).containsExactly("a.isOver=true", "a.isActive=true", "a.isOver=false");
    point(1, false);
    assertThat(nodes.sent()).containsExactly("a.isActive=false", "b.isOver=true");
    point(1, true);
    point(1, false);
    assertThat(nodes.sent())
        .containsExactly("b.isActive=true", "b.isActive=false", "b.touchTime=0.0");
  }

  @Test
  void aButtonThatWentDownElsewhereActivatesNothing() {
    scene(shape(), nodes.group(shape(), sensor("a")));
    point(0, true);
    point(1, true);
    assertThat(nodes.sent()).containsExactly("a.isOver=true");
    dispatch.point(Optional.empty(), Optional.empty(), false, nodes.cascade);
    assertThat(nodes.sent()).containsExactly("a.isOver=false");
  }

  @Test
  void theHitIsInTheSensorsCoordinates() {
    Node sensor = nodes.node("TouchSensor");
    scene(
        nodes.node(
            "Transform",
            "scale",
            new float[] {2, 8, 1},
            "rotation",
            new float[] {0, 0, 1, (float) Math.PI / 2},
            "children",
            List.of(shape(), sensor)));
    point(0, false);
    assertThat(sensor.floats("hitPoint_changed"))
        .usingComparatorWithPrecision(1e-6f)
        .containsExactly(0, -0.5f, 0);
    assertThat(sensor.floats("hitNormal_changed"))
        .usingComparatorWithPrecision(1e-6f)
        .containsExactly(1, 0, 0);
  }

  @Test
  void goingFromOnePlaceOfASensorToAnotherIsNotLeavingIt() {
    Node shared = nodes.group(shape(), sensor("a"));
    scene(shared, nodes.transform(5, 0, 0, shared));
    point(0, false);
    point(1, false);
    assertThat(nodes.sent()).containsExactly("a.isOver=true");
  }
}
