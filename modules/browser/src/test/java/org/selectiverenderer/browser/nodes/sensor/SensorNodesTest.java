package org.selectiverenderer.browser.nodes.sensor;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.browser.TestNodes;
import org.selectiverenderer.browser.nodes.group.CollisionNode;
import org.selectiverenderer.browser.scene.Node;

/** VisibilitySensor, TransformSensor, TouchSensor and Collision. */
class SensorNodesTest {
  private final TestNodes nodes = new TestNodes();
  private final TestFrameContext frame = new TestFrameContext();

  private VisibilitySensorNode visibility(float x, float y, float z, Matrix4d place) {
    VisibilitySensorNode sensor =
        (VisibilitySensorNode) nodes.node("VisibilitySensor", "size", new float[] {x, y, z});
    frame.place(sensor, place);
    return nodes.watch(sensor);
  }

  @Test
  void aBoxIsVisibleInFrontOfTheViewerOnly() {
    VisibilitySensorNode sensor = visibility(1, 1, 1, new Matrix4d().translation(0, 0, -5));
    frame.step(sensor, 1, nodes.cascade);
    assertThat(nodes.sent()).containsExactly("isActive=true", "enterTime=1.0");
    frame.orientation.rotationY(Math.PI);
    frame.step(sensor, 2, nodes.cascade);
    assertThat(nodes.sent()).containsExactly("isActive=false", "exitTime=2.0");
  }

  @Test
  void aTurnedBoxWhoseAxisAlignedBoxIsInViewMayBeOutOfIt() {
    // The view's right edge at z = -5 is x = 5; the plate's tip is at 6 - 4 / 2 * cos 45 > 4.5
    // in x, but there it is at z = -5 + 1.41 where the view ends at 3.59.
    Matrix4d plate = new Matrix4d().translation(6, 0, -5).rotateY(Math.PI / 4);
    VisibilitySensorNode sensor = visibility(4, 0.1f, 0.1f, plate);
    frame.step(sensor, 1, nodes.cascade);
    assertThat(sensor.active()).isFalse();
    frame.place(sensor, new Matrix4d().translation(6, 0, -5).rotateY(-Math.PI / 4));
    frame.step(sensor, 2, nodes.cascade);
    assertThat(sensor.active()).isTrue();
  }

  @Test
  void aBoxAroundTheViewerIsVisibleAndAPointIsNot() {
    VisibilitySensorNode around = visibility(50, 50, 50, new Matrix4d());
    VisibilitySensorNode point = visibility(0, 0, 0, new Matrix4d().translation(0, 0, -5));
    VisibilitySensorNode nowhere = visibility(1, 1, 1, new Matrix4d().m32(Double.NaN));
    frame.step(around, 1, nodes.cascade);
    frame.step(point, 1, nodes.cascade);
    frame.step(nowhere, 1, nodes.cascade);
    assertThat(around.active()).isTrue();
    assertThat(point.active()).isFalse();
    assertThat(nowhere.active()).isFalse();
  }

  @Test
  void aTransformThatMovesThroughABoxIsSensed() {
    Node target = nodes.transform(5, 0, 0);
    TransformSensorNode sensor =
        (TransformSensorNode)
            nodes.watch(
                nodes.node(
                    "TransformSensor", "size", new float[] {2, 2, 2}, "targetObject", target));
    frame.place(sensor, new Matrix4d()).place(target, new Matrix4d());
    frame.step(sensor, 1, nodes.cascade);
    assertThat(nodes.sent()).isEmpty();
    target.init(target.type().indexOf("translation"), new float[] {0.5f, 0, 0});
    frame.step(sensor, 2, nodes.cascade);
    assertThat(nodes.sent())
        .containsExactly(
            "isActive=true",
            "enterTime=2.0",
            "position_changed=0.5 0.0 0.0",
            "orientation_changed=0.0 0.0 1.0 0.0");
    target.init(target.type().indexOf("translation"), new float[] {5, 0, 0});
    frame.step(sensor, 3, nodes.cascade);
    assertThat(nodes.sent()).containsExactly("isActive=false", "exitTime=3.0");
  }

  private static final Optional<PointerHit> HIT =
      Optional.of(new PointerHit(new Vector3d(1, 2, 3), new Vector3d(0, 0, 1), 0.25f, 0.5f));

  private TouchSensorNode touch() {
    return (TouchSensorNode) nodes.watch(nodes.node("TouchSensor"));
  }

  @Test
  void aClickSendsOverHitActiveAndTouchTime() {
    TouchSensorNode sensor = touch();
    nodes.cascade.at(1);
    sensor.point(HIT, Optional.empty(), false, nodes.cascade);
    assertThat(nodes.sent())
        .containsExactly(
            "isOver=true",
            "hitPoint_changed=1.0 2.0 3.0",
            "hitNormal_changed=0.0 0.0 1.0",
            "hitTexCoord_changed=0.25 0.5");
    sensor.point(HIT, Optional.empty(), true, nodes.cascade);
    assertThat(nodes.sent()).containsExactly("isActive=true");
    nodes.cascade.at(2);
    sensor.point(HIT, Optional.empty(), false, nodes.cascade);
    assertThat(nodes.sent()).containsExactly("isActive=false", "touchTime=2.0");
    sensor.point(Optional.empty(), Optional.empty(), false, nodes.cascade);
    assertThat(nodes.sent()).containsExactly("isOver=false");
  }

  @Test
  void aReleaseElsewhereIsNoTouch() {
    TouchSensorNode sensor = touch();
    sensor.point(HIT, Optional.empty(), true, nodes.cascade);
    sensor.point(Optional.empty(), Optional.empty(), true, nodes.cascade);
    nodes.sent();
    sensor.point(Optional.empty(), Optional.empty(), false, nodes.cascade);
    assertThat(nodes.sent()).containsExactly("isActive=false");
  }

  @Test
  void disablingATouchSensorEndsWhatItSenses() {
    TouchSensorNode sensor = touch();
    sensor.point(HIT, Optional.empty(), true, nodes.cascade);
    nodes.sent();
    nodes.send(sensor, "enabled", false);
    assertThat(nodes.sent()).containsExactly("enabled=false", "isActive=false", "isOver=false");
    sensor.point(HIT, Optional.empty(), true, nodes.cascade);
    assertThat(nodes.sent()).isEmpty();
  }

  @Test
  void aCollisionIsToldOnceAndADisabledOneNot() {
    CollisionNode collision = (CollisionNode) nodes.watch(nodes.node("Collision"));
    nodes.cascade.at(3);
    collision.collide(true, nodes.cascade);
    collision.collide(true, nodes.cascade);
    assertThat(nodes.sent()).containsExactly("collideTime=3.0", "isActive=true");
    collision.collide(false, nodes.cascade);
    assertThat(nodes.sent()).containsExactly("isActive=false");
    nodes.send(collision, "enabled", false);
    nodes.sent();
    collision.collide(true, nodes.cascade);
    assertThat(nodes.sent()).isEmpty();
  }
}
