package org.selectiverenderer.modelling;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.selectiverenderer.geometry.mesh.TriangleMesh;

class GridSnappingTest {
  private static final ModelMaterial GREY = ModelMaterial.matt(ModelColour.grey(0.5));

  @Test
  void whatFallsTogetherIsJoinedAndTheHoleCloses() {
    // A box of 0.5 m whose chamfers are narrower than the grid's hundredth of a millimetre.
    ParametricModel sharp =
        GridSnapping.toGrid(
            ParametricModel.of(
                "box", Part.of("box", GREY, BoxBuilder.bevelled(0.5, 0.5, 0.5, 1e-6, 1))));

    TriangleMesh mesh = sharp.parts().get(0).mesh();
    assertThat(mesh.triangleCount()).isEqualTo(12);
    assertThat(mesh.isClosed()).isTrue();
  }

  @Test
  void aTriangleThatBecomesALineIsDropped() {
    float[] points = {0, 0, 0, 0.4f, 0, 0, 0.2f, 1e-6f, 0, 0, 0.4f, 0};
    TriangleMesh mesh = new TriangleMesh(points, new int[] {0, 1, 2, 0, 1, 3});

    ParametricModel rounded =
        GridSnapping.toGrid(ParametricModel.of("sheet", Part.of("sheet", GREY, mesh)));

    assertThat(rounded.polygons()).isEqualTo(1);
  }

  @Test
  void whatIsOnTheGridStays() {
    ParametricModel box =
        ParametricModel.of("box", Part.of("box", GREY, BoxBuilder.plain(0.25, 0.5, 0.125)));

    assertThat(GridSnapping.toGrid(box).parts().get(0).mesh()).isEqualTo(box.parts().get(0).mesh());
  }
}
