package org.selectiverenderer.modelling;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.stream.Stream;
import org.assertj.core.data.Percentage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.geometry.DegreeMath;
import org.selectiverenderer.geometry.mesh.MeshMeasures;
import org.selectiverenderer.geometry.mesh.TriangleMesh;

/** Every form is closed, faces outwards, and has the volume and the triangles that it says. */
class SolidFormsTest {
  private static final SimplePolygon L =
      SimplePolygon.of(0, 0, 0.3, 0, 0.3, 0.1, 0.1, 0.1, 0.1, 0.4, 0, 0.4);

  static Stream<Arguments> solids() {
    double circle48 = 24 * DegreeMath.sin(7.5); // area of a 48-gon of radius 1
    SimplePolygon hole = SimplePolygon.rectangle(0.1, 0.1);
    return Stream.of(
        solid("box", BoxBuilder.plain(1, 2, 3), 12, 6),
        solid("chamfered box", BoxBuilder.bevelled(1, 2, 3, 0.1, 1), 44, 5.8800),
        solid("bevelled box", BoxBuilder.bevelled(0.4, 0.2, 0.3, 0.05, 4), 332, 0.02225),
        solid("capsule-like box", BoxBuilder.bevelled(0.2, 0.2, 0.2, 0.1, 8), -1, 0.00405),
        solid("cylinder", RoundSolidBuilder.cylinder(1, 2, 48), 192, 2 * circle48),
        solid("cone", RoundSolidBuilder.cone(1, 0, 3, 48), 96, circle48),
        solid("truncated cone", RoundSolidBuilder.cone(2, 1, 3, 48), 192, 7 * circle48),
        solid("sphere", RoundSolidBuilder.sphere(1, 64, 128), 2 * 128 * 63, 4.18),
        solid("ellipsoid", RoundSolidBuilder.ellipsoid(1, 2, 3, 64, 128), 2 * 128 * 63, 25.07),
        solid("pillow", RoundSolidBuilder.superellipsoid(1, 1, 1, 40, 40, 64, 128), -1, 7.9),
        solid(
            "rounded cylinder",
            RoundSolidBuilder.roundedCylinder(1, 2, 0.25, 3, 48),
            48 * 4 * 4,
            6.11),
        solid("capsule", RoundSolidBuilder.capsule(1, 4, 16, 64), -1, 10.44),
        solid("torus", RoundSolidBuilder.torus(2, 0.5, 64, 32), 2 * 64 * 32, 9.79),
        solid("pipe", RoundSolidBuilder.pipe(1, 0.5, 2, 48), 8 * 48, 1.5 * circle48),
        solid("extruded L", ExtrudedSolid.plain(0.5, L), 20, 0.03),
        solid("bevelled L", ExtrudedSolid.bevelled(0.5, 0.02, 3, L), 8 + 7 * 12, 0.0297),
        solid(
            "bevel as deep as can be",
            ExtrudedSolid.bevelled(0.08, 0.04, 2, L),
            8 + 4 * 12,
            0.003567),
        solid(
            "plate with two holes",
            ExtrudedSolid.bevelled(
                0.1,
                0.01,
                1,
                SimplePolygon.roundedRectangle(0.8, 0.6, 0.1, 4),
                hole.move(-0.2, 0.05),
                hole.move(0.2, 0)),
            2 * (28 - 2 + 4) + 3 * 56,
            0.0449),
        solid("lying plate", ExtrudedSolid.plate(0.1, 0, 0, L), 20, 0.006),
        solid("tube", Sweep.tube(Spine.of(0, 0, 0, 0, 0, 5), 1, 48), 4 * 48, 5 * circle48),
        solid(
            "mitred frame",
            Sweep.of(SimplePolygon.rectangle(0.1, 0.1), Spine.of(SimplePolygon.rectangle(1, 2))),
            32,
            0.06),
        solid(
            "mitred elbow",
            Sweep.of(SimplePolygon.rectangle(0.1, 0.1), Spine.of(0, 0, 0, 1, 0, 0, 1, 1, 0)),
            24,
            0.02),
        solid("spring", Sweep.tube(Spine.helix(1, 2, 3, 32), 0.1, 12), -1, 0.03 * 6.283 * 2.97),
        solid("tip", Sweep.tube(Spine.of(0, 0, 0, 0, 3, 0), 48, t -> 1 - t), 48 * 2, circle48),
        solid(
            "thick sheet",
            ParametricSurface.thicken(
                ParametricSurface.field(2, 3, 4, 5, (x, z) -> 0.3 * x), 0, -0.1, 0),
            2 * 40 + 2 * 18,
            0.6),
        solid(
            "letters",
            ParametricSurface.thicken(TextGeometry.bold().flat("EOB8", 1), 0, 0, 0.2),
            -1,
            0.3));
  }

  private static Arguments solid(String name, TriangleMesh mesh, int triangles, double volume) {
    return Arguments.of(name, mesh, triangles, volume);
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("solids")
  void isClosedAndFacesOutwards(String name, TriangleMesh mesh, int triangles, double volume) {
    assertThat(mesh.isClosed()).isTrue();
    assertThat(MeshMeasures.volume(mesh)).isPositive();
    for (int t = 0; t < mesh.triangleCount(); t++) {
      assertThat(MeshMeasures.normal(mesh, t).length()).as("triangle " + t).isGreaterThan(1e-9);
    }
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("solids")
  void hasItsVolumeAndItsTriangles(String name, TriangleMesh mesh, int triangles, double volume) {
    assertThat(MeshMeasures.volume(mesh))
        .isCloseTo(volume, Percentage.withPercentage(name.equals("letters") ? 60 : 2));
    if (triangles > 0) {
      assertThat(mesh.triangleCount()).isEqualTo(triangles);
    }
  }

  @Test
  void solidsStandOnTheFloorInTheMiddle() {
    for (TriangleMesh mesh :
        new TriangleMesh[] {
          BoxBuilder.plain(2, 1, 4),
          BoxBuilder.bevelled(2, 1, 4, 0.2, 2),
          RoundSolidBuilder.cylinder(1, 2, 8),
          RoundSolidBuilder.roundedCylinder(1, 2, 0.1, 2, 8)
        }) {
      BoundingBox b = mesh.bounds();
      assertThat(b.minY()).isZero();
      assertThat(b.minX()).isCloseTo(-b.maxX(), within(1e-6));
      assertThat(b.minZ()).isCloseTo(-b.maxZ(), within(1e-6));
    }
  }

  @Test
  void openFormsFaceOutwardsToo() {
    TriangleMesh wall = Lathe.surface(ProfileCurve.of(1, 0, 1, 2), 16);
    TriangleMesh floor = ParametricSurface.field(1, 1, 2, 2, (x, z) -> 0);

    assertThat(wall.isClosed()).isFalse();
    assertThat(MeshMeasures.normal(wall, 0).x).isPositive();
    assertThat(MeshMeasures.normal(floor, 0).y).isPositive();
    assertThat(MeshMeasures.normal(TextGeometry.bold().flat("I", 1), 0).z).isPositive();
  }

  @Test
  void aFaceIsTheFrontOfItsPrism() {
    TriangleMesh face =
        ExtrudedSolid.face(SimplePolygon.rectangle(2, 1), SimplePolygon.circle(0.3, 8));

    assertThat(face.triangleCount()).isEqualTo(12 - 2 + 2);
    assertThat(MeshMeasures.area(face))
        .isCloseTo(2 - SimplePolygon.circle(0.3, 8).area(), within(1e-6));
    for (int t = 0; t < face.triangleCount(); t++) {
      assertThat(MeshMeasures.normal(face, t).z).isPositive();
    }
  }

  @Test
  void mirroringKeepsTheOutsideOutside() {
    assertThat(MeshMeasures.volume(BoxBuilder.plain(1, 1, 1).mirrorX())).isPositive();
    assertThat(MeshMeasures.volume(MeshPatterns.corners(BoxBuilder.plain(1, 1, 1), 2, 2)))
        .isCloseTo(4, within(1e-6));
  }

  @Test
  void whatHasNoRoomIsRefused() {
    assertThatThrownBy(() -> ExtrudedSolid.bevelled(1, 0.06, 1, L))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("larger than the outline");
    assertThatThrownBy(() -> BoxBuilder.bevelled(1, 1, 1, 0.6, 1))
        .isInstanceOf(IllegalArgumentException.class);
    assertThatThrownBy(() -> Lathe.solid(ProfileCurve.of(-1, 0, 1, 1), 8))
        .isInstanceOf(IllegalArgumentException.class);
  }
}
