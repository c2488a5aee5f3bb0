package org.selectiverenderer.x3d.tessellate;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.geometry.mesh.Mesh;

class PrimitivesTest extends AbstractTessellatorTest {
  /** Area of the polygon of 32 sides in a unit circle. */
  private static final double DISK = 16 * Math.sin(Math.PI / 16);

  @Test
  void boxIsClosedAndFacesOutwards() {
    Mesh box = mesh("Box", "size", new float[] {2, 3, 4});
    assertThat(box.polygons()).isEqualTo(12);
    assertThat(box.vertexCount()).isEqualTo(24);
    assertThat(MeshProperties.volume(box)).isCloseTo(24, within(1e-5));
    assertThat(MeshProperties.area(box)).isCloseTo(52, within(1e-5));
    assertThat(MeshProperties.euler(box)).isEqualTo(2);
    assertThat(box.bounds()).containsExactly(-1, -1.5f, -2, 1, 1.5f, 2);
    assertThat(box.solid()).isTrue();
  }

  @ParameterizedTest
  @ValueSource(strings = {"Box", "Sphere", "Cone", "Cylinder"})
  void closedShapesAreClosedWithNormalsOutwards(String type) {
    Mesh mesh = mesh(type);
    assertThat(MeshProperties.euler(mesh)).isEqualTo(2);
    assertThat(MeshProperties.volume(mesh)).isPositive();
    MeshProperties.assertNormalsAgreeWithWinding(mesh);
  }

  @Test
  void volumesComeCloseToTheRoundOnes() {
    assertThat(MeshProperties.volume(mesh("Sphere", "radius", 2f)))
        .isCloseTo(4.0 / 3 * Math.PI * 8, within(1.0));
    assertThat(MeshProperties.volume(mesh("Cylinder", "radius", 2f, "height", 3f)))
        .isCloseTo(4 * DISK * 3, within(1e-4));
    assertThat(MeshProperties.volume(mesh("Cone", "bottomRadius", 2f, "height", 3f)))
        .isCloseTo(4 * DISK, within(1e-4));
  }

  @Test
  void trianglesAreAsDocumented() {
    assertThat(mesh("Sphere").polygons()).isEqualTo(960);
    assertThat(mesh("Cylinder").polygons()).isEqualTo(124);
    assertThat(mesh("Cone").polygons()).isEqualTo(62);
  }

  @Test
  void partsCanBeLeftOut() {
    assertThat(mesh("Cylinder", "top", false).polygons()).isEqualTo(94);
    assertThat(mesh("Cylinder", "bottom", false, "side", false).polygons()).isEqualTo(30);
    assertThat(MeshProperties.normal(mesh("Cylinder", "bottom", false, "side", false), 0))
        .containsExactly(0, 1, 0);
    assertThat(MeshProperties.normal(mesh("Cone", "side", false), 0)).containsExactly(0, -1, 0);
    assertThat(mesh("Cone", "side", false, "bottom", false).isEmpty()).isTrue();
  }

  @Test
  void everyBoxFaceShowsTheWholeTextureUpright() {
    Mesh box = mesh("Box");
    assertThat(texCoordAt(box, -1, 1, 1, 2, 1)).containsExactly(0, 1); // front, top left
    assertThat(texCoordAt(box, 1, 1, -1, 2, -1)).containsExactly(0, 1); // back, seen from behind
    assertThat(texCoordAt(box, 1, 1, 1, 0, 1)).containsExactly(0, 1); // right
    assertThat(texCoordAt(box, -1, 1, -1, 0, -1)).containsExactly(0, 1); // left
    assertThat(texCoordAt(box, -1, 1, -1, 1, 1)).containsExactly(0, 1); // top, back left
    assertThat(texCoordAt(box, -1, -1, 1, 1, -1)).containsExactly(0, 1); // bottom, front left
  }

  @Test
  void texturesWrapFromTheBackCounterClockwiseSeenFromAbove() {
    for (String type : new String[] {"Sphere", "Cylinder"}) {
      Mesh mesh = mesh(type, "radius", 1f);
      assertThat(sideS(mesh, -1, 0)).isCloseTo(0.25, within(1e-6));
      assertThat(sideS(mesh, 0, 1)).isCloseTo(0.5, within(1e-6));
      assertThat(sideS(mesh, 1, 0)).isCloseTo(0.75, within(1e-6));
    }
    Mesh top = mesh("Cylinder", "side", false, "bottom", false);
    assertThat(texCoordAt(top, 0, 1, -1, 1, 1)).containsExactly(0.5f, 1);
    Mesh bottom = mesh("Cylinder", "side", false, "top", false);
    assertThat(texCoordAt(bottom, 0, -1, 1, 1, -1)).containsExactly(0.5f, 1);
  }

  @Test
  void sizesThatAreNotPositiveAreReportedAndDrawNothing() {
    assertThat(mesh(node("Box", "size", new float[] {1, -1, 1})).isEmpty()).isTrue();
    assertThat(mesh(node("Sphere", "radius", Float.NaN)).isEmpty()).isTrue();
    assertThat(messages())
        .containsExactly(
            "Box has a size that is not above 0; it is left out",
            "Sphere has a radius that is not above 0; it is left out");
  }

  @Test
  void otherNodesAreNotHandled() {
    assertThat(tessellator.handles(node("Material").type())).isFalse();
    assertThat(tessellator.tessellate(node("Material"), problems)).isEmpty();
    assertThat(tessellator.handles(node("Box").type())).isTrue();
  }

  /** S and T of the vertex at x, y, z whose normal has that sign along an axis. */
  private static float[] texCoordAt(Mesh mesh, float x, float y, float z, int axis, int sign) {
    for (int v = 0; v < mesh.vertexCount(); v++) {
      if (Math.abs(mesh.positions()[3 * v] - x) < 1e-6
          && Math.abs(mesh.positions()[3 * v + 1] - y) < 1e-6
          && Math.abs(mesh.positions()[3 * v + 2] - z) < 1e-6
          && mesh.normals()[3 * v + axis] * sign > 0.5) {
        return new float[] {mesh.texCoords()[2 * v], mesh.texCoords()[2 * v + 1]};
      }
    }
    throw new AssertionError("no such vertex");
  }

  private static double sideS(Mesh mesh, double nx, double nz) {
    for (int v = 0; v < mesh.vertexCount(); v++) {
      if (Math.abs(mesh.normals()[3 * v] - nx) < 1e-6
          && Math.abs(mesh.normals()[3 * v + 2] - nz) < 1e-6) {
        return mesh.texCoords()[2 * v];
      }
    }
    throw new AssertionError("no such vertex");
  }
}
