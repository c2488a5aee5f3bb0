package org.selectiverenderer.models.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.joml.Matrix4d;
import org.junit.jupiter.api.Test;

class SkinTest {
  @Test
  void theDeepestJointTellsHowDeepASkinIs() {
    List<ModelNode> nodes = new ArrayList<>();
    double[] unit = new Matrix4d().get(new double[16]);
    for (int i = 0; i < 5; i++) {
      nodes.add(new ModelNode(i - 1, "", NodeTransform.of(unit)));
    }
    Skin skin = new Skin(nodes, new int[] {1, 3}, List.of(unit, unit));

    assertThat(skin.isDeeperThan(3)).isTrue();
    assertThat(skin.isDeeperThan(4)).isFalse();
  }
}
