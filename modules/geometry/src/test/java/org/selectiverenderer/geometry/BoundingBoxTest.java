package org.selectiverenderer.geometry;

import static org.assertj.core.api.Assertions.assertThat;

import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

class BoundingBoxTest {
  private static final BoundingBox BOX =
      BoundingBox.around(new float[] {1, 2, 3, 3, 2, 4, 2, 6, 3});

  @Test
  void theBoxAroundPointsTouchesThem() {
    assertThat(BOX).isEqualTo(new BoundingBox(1, 2, 3, 3, 6, 4));
    assertThat(BOX.extent()).isEqualTo(4);
    assertThat(BOX.volume()).isEqualTo(8);
    assertThat(BOX.corner(5)).isEqualTo(new Vector3d(3, 2, 4));
    assertThat(BoundingBox.of(BOX.toArray())).isEqualTo(BOX);
  }

  @Test
  void nothingIsEmptyAndAddsNothing() {
    assertThat(BoundingBox.around(new float[0]).isEmpty()).isTrue();
    assertThat(BoundingBox.EMPTY.volume()).isZero();
    assertThat(BoundingBox.EMPTY.union(BOX)).isEqualTo(BOX);
    assertThat(BOX.union(BoundingBox.EMPTY)).isEqualTo(BOX);
    assertThat(BoundingBox.EMPTY.transformed(new Matrix4d().translation(1, 0, 0)).isEmpty())
        .isTrue();
  }

  @Test
  void boxesThatTouchAreNotApart() {
    BoundingBox beside = BOX.transformed(new Matrix4d().translation(2, 0, 0));
    assertThat(BOX.apart(beside)).isFalse();
    assertThat(beside.contains(new Vector3d(3, 2, 3))).isTrue();
    assertThat(BOX.apart(beside.grown(-0.25))).isTrue();
  }
}
