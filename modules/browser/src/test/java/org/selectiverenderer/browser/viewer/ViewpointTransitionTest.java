package org.selectiverenderer.browser.viewer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.browser.viewer.ViewpointTransition.Type;

class ViewpointTransitionTest {
  private final Pose from = new Pose(new Vector3d(), Viewer.orientation(3, 0, 0), 0.5);
  private final Pose to = new Pose(new Vector3d(8, 0, 0), Viewer.orientation(-3, 0, 0), 1);

  private Pose at(Type type, double time) {
    return new ViewpointTransition(from, to, type, 10, 2).at(time);
  }

  @Test
  void linearIsAtAConstantPaceAndTurnsTheShortWay() {
    Pose half = at(Type.LINEAR, 11);
    assertThat(half.position().x()).isCloseTo(4, within(1e-12));
    assertThat(half.fieldOfView()).isCloseTo(0.75, within(1e-12));
    assertThat(Math.abs(half.orientation().dot(Viewer.orientation(Math.PI, 0, 0))))
        .isCloseTo(1, within(1e-12));
    assertThat(at(Type.LINEAR, 10.5).position().x()).isCloseTo(2, within(1e-12));
  }

  @Test
  void animateBeginsAndEndsGently() {
    assertThat(at(Type.ANIMATE, 10.5).position().x()).isLessThan(2);
    assertThat(at(Type.ANIMATE, 11).position().x()).isCloseTo(4, within(1e-12));
    assertThat(at(Type.ANIMATE, 11.5).position().x()).isGreaterThan(6);
  }

  @Test
  void itEndsExactlyAtTheViewpointAndTeleportingIsThereAtOnce() {
    ViewpointTransition linear = new ViewpointTransition(from, to, Type.LINEAR, 10, 2);
    assertThat(linear.done(11.9)).isFalse();
    assertThat(linear.done(12)).isTrue();
    Viewer viewer = new Viewer();
    linear.move(viewer, 13, 0.1);
    assertThat(viewer.position().x()).isEqualTo(8);
    assertThat(viewer.fieldOfView()).isEqualTo(1);
    assertThat(at(Type.TELEPORT, 10)).isEqualTo(to);
    assertThat(new ViewpointTransition(from, to, Type.LINEAR, 10, 0).at(10)).isEqualTo(to);
  }

  @Test
  void theFirstKnownTypeCounts() {
    assertThat(Type.of("FANCY", "ANIMATE", "TELEPORT")).isEqualTo(Type.ANIMATE);
    assertThat(Type.of()).isEqualTo(Type.LINEAR);
  }
}
