package org.selectiverenderer.modelling;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.geometry.mesh.MeshMeasures;
import org.selectiverenderer.geometry.mesh.TriangleMesh;

class ExactCountRefinerTest {
  private static final ModelMaterial GREY = ModelMaterial.matt(ModelColour.grey(0.5));

  @Test
  void closedModelsReachEveryEvenCount() {
    ParametricModel model =
        ParametricModel.of(
            "pair",
            Part.of("box", GREY, BoxBuilder.bevelled(1, 2, 3, 0.2, 2)),
            Part.of("ball", GREY, RoundSolidBuilder.sphere(0.5, 8, 12)));
    Random random = new Random(5);
    for (int i = 0; i < 40; i++) {
      int target = model.polygons() + 2 * random.nextInt(3000);
      ParametricModel refined = ExactCountRefiner.refine(model, target);

      assertThat(refined.polygons()).isEqualTo(target);
      for (int p = 0; p < 2; p++) {
        TriangleMesh before = model.parts().get(p).mesh();
        TriangleMesh after = refined.parts().get(p).mesh();
        assertThat(after.isClosed()).isTrue();
        assertThat(MeshMeasures.volume(after)).isCloseTo(MeshMeasures.volume(before), within(1e-5));
        assertThat(MeshMeasures.area(after)).isCloseTo(MeshMeasures.area(before), within(1e-5));
      }
    }
  }

  @Test
  void aBorderMakesOddCountsPossible() {
    ParametricModel model =
        ParametricModel.of(
            "cup",
            Part.of("wall", GREY, Lathe.surface(ProfileCurve.of(1, 0, 2, 3), 12)),
            Part.of("ball", GREY, RoundSolidBuilder.sphere(5, 8, 12)));
    for (int target = model.polygons(); target < model.polygons() + 60; target++) {
      assertThat(ExactCountRefiner.refine(model, target).polygons()).isEqualTo(target);
    }
  }

  @Test
  void noTriangleTurnsOver() {
    TriangleMesh hill = ParametricSurface.field(2, 2, 7, 7, (x, z) -> 0.2 * x * x - 0.3 * z);
    ParametricModel refined =
        ExactCountRefiner.refine(ParametricModel.of("hill", Part.of("hill", GREY, hill)), 1999);

    TriangleMesh mesh = refined.parts().get(0).mesh();
    assertThat(mesh.triangleCount()).isEqualTo(1999);
    for (int t = 0; t < mesh.triangleCount(); t++) {
      Vector3d normal = MeshMeasures.normal(mesh, t);
      assertThat(normal.y).isGreaterThan(0.5 * normal.length()).isPositive();
    }
    assertThat(MeshMeasures.area(mesh)).isCloseTo(MeshMeasures.area(hill), within(1e-5));
  }

  @Test
  void theLongestEdgeIsSplitFirst() {
    TriangleMesh long1 = BoxBuilder.plain(1, 1, 8);
    TriangleMesh short1 = BoxBuilder.plain(1, 1, 1);
    ParametricModel refined =
        ExactCountRefiner.refine(
            ParametricModel.of(
                "boxes", Part.of("short", GREY, short1), Part.of("long", GREY, long1)),
            40);

    assertThat(refined.parts().get(0).mesh()).isEqualTo(short1);
    assertThat(refined.parts().get(1).mesh().triangleCount()).isEqualTo(28);
  }

  @Test
  void whatCannotBeIsSaid() {
    ParametricModel box =
        ParametricModel.of("box", Part.of("box", GREY, BoxBuilder.plain(1, 1, 1)));

    assertThatThrownBy(() -> ExactCountRefiner.refine(box, 13))
        .hasMessageContaining("closed everywhere");
    assertThatThrownBy(() -> ExactCountRefiner.refine(box, 10)).hasMessageContaining("12 polygons");
  }
}
