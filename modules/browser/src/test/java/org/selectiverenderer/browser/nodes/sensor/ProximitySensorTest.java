package org.selectiverenderer.browser.nodes.sensor;

import static org.assertj.core.api.Assertions.assertThat;

import org.joml.Matrix4d;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.selectiverenderer.browser.TestNodes;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.Rotations;

class ProximitySensorTest {
  private final TestNodes nodes = new TestNodes();
  private final TestFrameContext frame = new TestFrameContext();

  private ProximitySensorNode sensor(float x, float y, float z, Matrix4d... places) {
    ProximitySensorNode sensor =
        (ProximitySensorNode) nodes.node("ProximitySensor", "size", new float[] {x, y, z});
    frame.place(sensor, places);
    return nodes.watch(sensor);
  }

  private void eyeAt(ProximitySensorNode sensor, double time, double x, double y, double z) {
    frame.eye.set(x, y, z);
    frame.step(sensor, time, nodes.cascade);
  }

  @Test
  void enteringMovingAndLeavingAreSentInOrder() {
    ProximitySensorNode sensor = sensor(2, 2, 2, new Matrix4d());
    eyeAt(sensor, 1, 5, 0, 0);
    assertThat(nodes.sent()).isEmpty();
    eyeAt(sensor, 2, 0.5, 0, 0);
    assertThat(nodes.sent())
        .containsExactly(
            "isActive=true",
            "enterTime=2.0",
            "position_changed=0.5 0.0 0.0",
            "orientation_changed=0.0 0.0 1.0 0.0");
    eyeAt(sensor, 3, 0.25, 0, 0);
    assertThat(nodes.sent()).containsExactly("position_changed=0.25 0.0 0.0");
    eyeAt(sensor, 4, 0.25, 0, 0);
    assertThat(nodes.sent()).isEmpty();
    eyeAt(sensor, 5, 5, 0, 0);
    assertThat(nodes.sent()).containsExactly("isActive=false", "exitTime=5.0");
  }

  @Test
  void theBoundaryBelongsToTheBox() {
    ProximitySensorNode sensor = sensor(2, 4, 6, new Matrix4d());
    eyeAt(sensor, 1, 1, -2, 3);
    assertThat(sensor.active()).isTrue();
    eyeAt(sensor, 2, Math.nextUp(1.0), -2, 3);
    assertThat(sensor.active()).isFalse();
  }

  @ParameterizedTest
  @CsvSource({"0,2,2", "2,0,2", "2,2,0", "-2,2,2", "2,2,-1", "NaN,2,2", "0,0,0"})
  void aBoxWithoutAnInsideIsNeverActive(float x, float y, float z) {
    ProximitySensorNode sensor = sensor(x, y, z, new Matrix4d());
    eyeAt(sensor, 1, 0, 0, 0);
    assertThat(nodes.sent()).isEmpty();
  }

  @Test
  void aTurnedBoxIsNotItsAxisAlignedBox() {
    // Turned by 45 degrees the corner region (0.9, 0, 0.9) is outside, (1.3, 0, 0) inside.
    ProximitySensorNode sensor = sensor(2, 2, 2, new Matrix4d().rotateY(Math.PI / 4));
    eyeAt(sensor, 1, 0.9, 0, 0.9);
    assertThat(sensor.active()).isFalse();
    eyeAt(sensor, 2, 1.3, 0, 0);
    assertThat(sensor.active()).isTrue();
  }

  @Test
  void disablingWhileInsideLeavesAtOnceAndEnablingEntersAtTheNextFrame() {
    ProximitySensorNode sensor = sensor(2, 2, 2, new Matrix4d());
    eyeAt(sensor, 1, 0, 0, 0);
    nodes.sent();
    nodes.cascade.at(1.5);
    nodes.send(sensor, "enabled", false);
    assertThat(nodes.sent()).containsExactly("enabled=false", "isActive=false", "exitTime=1.5");
    eyeAt(sensor, 2, 0, 0, 0);
    assertThat(nodes.sent()).isEmpty();
    nodes.send(sensor, "enabled", true);
    eyeAt(sensor, 3, 0, 0, 0);
    assertThat(nodes.sent()).contains("isActive=true", "enterTime=3.0");
  }

  @Test
  void aSensorThatItsOwnEventDisablesSendsNoPoseAndLeavesAtTheNextFrame() {
    ProximitySensorNode sensor = sensor(2, 2, 2, new Matrix4d());
    Node not = nodes.node("BooleanFilter");
    nodes.route(sensor, "isActive", not, "set_boolean");
    nodes.route(not, "inputNegate", sensor, "enabled");
    eyeAt(sensor, 1, 0, 0, 0);
    assertThat(nodes.sent()).containsExactly("isActive=true", "enabled=false", "enterTime=1.0");
    eyeAt(sensor, 2, 0, 0, 0);
    assertThat(nodes.sent()).startsWith("isActive=false").endsWith("exitTime=2.0");
  }

  @Test
  void aSensorInTwoPlacesSensesTheirUnionWithoutLeavingBetween() {
    ProximitySensorNode sensor =
        sensor(2, 2, 2, new Matrix4d(), new Matrix4d().translation(2, 0, 0));
    eyeAt(sensor, 1, 0.5, 0, 0);
    nodes.sent();
    eyeAt(sensor, 2, 2.5, 0, 0);
    assertThat(nodes.sent()).isEmpty(); // The pose is the same in the other place.
    eyeAt(sensor, 3, 2.25, 0, 0);
    assertThat(nodes.sent()).containsExactly("position_changed=0.25 0.0 0.0");
  }

  @Test
  void aBoxThatMovesOverTheViewerIsEntered() {
    ProximitySensorNode sensor = sensor(2, 2, 2, new Matrix4d().translation(10, 0, 0));
    eyeAt(sensor, 1, 0, 0, 0);
    assertThat(sensor.active()).isFalse();
    frame.place(sensor, new Matrix4d().translation(0.5, 0, 0));
    eyeAt(sensor, 2, 0, 0, 0);
    assertThat(nodes.sent()).contains("isActive=true", "position_changed=-0.5 0.0 0.0");
  }

  @Test
  void aSensorThatLeavesTheSceneIsLeft() {
    ProximitySensorNode sensor = sensor(2, 2, 2, new Matrix4d());
    eyeAt(sensor, 1, 0, 0, 0);
    frame.place(sensor);
    eyeAt(sensor, 2, 0, 0, 0);
    assertThat(sensor.active()).isFalse();
  }

  @Test
  void aScaleOfZeroAboveIsNeverActiveWhereverTheFlatBoxLies() {
    Matrix4d turned = new Matrix4d().rotateXYZ(0.3, 0.7, 1.1);
    Matrix4d flat =
        new Matrix4d(turned)
            .scale(1, 0, 1)
            .mul(turned.transpose(new Matrix4d()))
            .translate(0, 0, 0);
    ProximitySensorNode sensor = sensor(1e6f, 1e6f, 1e6f, flat);
    eyeAt(sensor, 1, 0, 0, 0);
    eyeAt(sensor, 2, 1e-20, 0, 0);
    frame.place(sensor, new Matrix4d().scale(0));
    eyeAt(sensor, 3, 0, 0, 0);
    assertThat(nodes.sent()).isEmpty();
  }

  @Test
  void valuesThatAreNotNumbersAreOutside() {
    ProximitySensorNode sensor = sensor(2, 2, 2, new Matrix4d());
    eyeAt(sensor, 1, Double.NaN, 0, 0);
    eyeAt(sensor, 2, Double.POSITIVE_INFINITY, 0, 0);
    frame.place(sensor, new Matrix4d().m30(Double.NaN));
    eyeAt(sensor, 3, 0, 0, 0);
    assertThat(nodes.sent()).isEmpty();
  }

  @Test
  void theOrientationIsTheViewersInTheBoxsCoordinates() {
    ProximitySensorNode sensor = sensor(9, 9, 9, new Matrix4d().rotateY(Math.PI / 2).scale(3));
    frame.orientation.rotationY(Math.PI / 2);
    eyeAt(sensor, 1, 0, 0, 0);
    assertThat(sensor.floats("orientation_changed")).containsExactly(0, 0, 1, 0);
    frame.orientation.rotationY(Math.PI);
    eyeAt(sensor, 2, 0, 0, 0);
    assertThat(sensor.floats("orientation_changed"))
        .usingComparatorWithPrecision(1e-6f)
        .containsExactly(0, 1, 0, (float) Math.PI / 2);
  }

  @Test
  void theLookingDirectionStaysTrueUnderShear() {
    Matrix4d sheared = new Matrix4d().m20(0.7).m10(0.3).scale(1, 2, 0.5);
    ProximitySensorNode sensor = sensor(9, 9, 9, sheared);
    frame.orientation.rotationXYZ(0.4, -1.2, 0.2);
    eyeAt(sensor, 1, 0, 0, 0);
    Vector3d expected =
        sheared
            .invert(new Matrix4d())
            .transformDirection(frame.orientation.transform(new Vector3d(0, 0, -1)))
            .normalize();
    Vector3d sent =
        Rotations.read(sensor.floats("orientation_changed"), 0, new Quaterniond())
            .transform(new Vector3d(0, 0, -1));
    assertThat(sent.distance(expected)).isLessThan(1e-6);
  }

  @Test
  void theCenterOfRotationIsSentWhenThereIsOne() {
    ProximitySensorNode sensor = sensor(2, 2, 2, new Matrix4d().translation(1, 0, 0));
    frame.centerOfRotation = new Vector3d(4, 5, 6);
    eyeAt(sensor, 1, 1, 0, 0);
    assertThat(nodes.sent()).contains("centerOfRotation_changed=3.0 5.0 6.0");
  }
}
