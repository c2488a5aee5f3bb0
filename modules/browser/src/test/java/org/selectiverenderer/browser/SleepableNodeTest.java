package org.selectiverenderer.browser;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.joml.FrustumIntersection;
import org.joml.Matrix4dc;
import org.joml.Quaterniond;
import org.joml.Quaterniondc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.browser.nodes.sensor.FrameContext;
import org.selectiverenderer.browser.nodes.sensor.FrameDrivenNode;
import org.selectiverenderer.browser.scene.Node;

/** Nodes at rest do not look at frames. */
class SleepableNodeTest {
  private final TestNodes nodes = new TestNodes();
  private final Node first = nodes.node("ScalarChaser");
  private final Node second = nodes.node("ScalarChaser");
  private final SensorScheduler round =
      new SensorScheduler(List.of((FrameDrivenNode) first, (FrameDrivenNode) second));

  private record At(double time) implements FrameContext {
    @Override
    public Vector3dc eye() {
      return new Vector3d();
    }

    @Override
    public Quaterniondc orientation() {
      return new Quaterniond();
    }

    @Override
    public FrustumIntersection frustum() {
      throw new UnsupportedOperationException();
    }

    @Override
    public List<? extends Matrix4dc> places(Node node) {
      return List.of();
    }
  }

  private int looked(double time) {
    nodes.cascade.at(time);
    return round.frame(new At(time), nodes.cascade);
  }

  @Test
  void atRestNoneLooksAndWhatBeginsWakes() {
    assertThat(looked(0)).isEqualTo(2);
    assertThat(looked(1)).isZero();
    nodes.send(second, "set_destination", 1f);
    assertThat(looked(1.5)).isEqualTo(1);
    assertThat(looked(2)).isEqualTo(1);
    assertThat(looked(3)).isZero();
  }

  @Test
  void oneThatIsWokenAfterItsTurnLooksAtTheNextFrame() {
    nodes.route(second, "value_changed", first, "set_destination");
    looked(0);
    nodes.send(second, "set_destination", 1f);
    assertThat(looked(0.5)).isEqualTo(1);
    assertThat(looked(1)).isEqualTo(2);
    assertThat(looked(2)).isEqualTo(1);
    assertThat(looked(3)).isZero();
    assertThat(first.number("value_changed")).isEqualTo(1);
  }
}
