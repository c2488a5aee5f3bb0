package org.selectiverenderer.x3d.tessellate;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.selectiverenderer.geometry.mesh.Mesh;

class ElevationGridTessellatorTest extends AbstractTessellatorTest {
  private static final float[] FLAT = {2, 2, 2, 2, 2, 2};

  private Mesh grid(Object... more) {
    Object[] fields = {"xDimension", 3, "zDimension", 2, "xSpacing", 2f, "zSpacing", 3f};
    Object[] all = java.util.Arrays.copyOf(fields, fields.length + more.length);
    System.arraycopy(more, 0, all, fields.length, more.length);
    return mesh("ElevationGrid", all);
  }

  @Test
  void liesOverTheXzPlaneAndFacesUp() {
    Mesh mesh = grid("height", FLAT, "creaseAngle", 1f);
    assertThat(mesh.polygons()).isEqualTo(4);
    assertThat(mesh.vertexCount()).isEqualTo(6);
    assertThat(MeshProperties.area(mesh)).isCloseTo(12, within(1e-5));
    assertThat(mesh.bounds()).containsExactly(0, 2, 0, 4, 2, 3);
    assertThat(MeshProperties.normal(mesh, 0))
        .containsExactly(new double[] {0, 1, 0}, within(1e-6));
    MeshProperties.assertNormalsAgreeWithWinding(mesh);
  }

  @Test
  void clockwiseGridFacesDown() {
    Mesh mesh = grid("height", FLAT, "ccw", false);
    assertThat(MeshProperties.normal(mesh, 0))
        .containsExactly(new double[] {0, -1, 0}, within(1e-6));
  }

  @Test
  void textureCoversTheGridWithSAlongXAndTAlongZ() {
    Mesh mesh = grid("height", FLAT);
    for (int v = 0; v < mesh.vertexCount(); v++) {
      assertThat(mesh.texCoords()[2 * v]).isEqualTo(mesh.positions()[3 * v] / 4);
      assertThat(mesh.texCoords()[2 * v + 1]).isEqualTo(mesh.positions()[3 * v + 2] / 3);
    }
  }

  @Test
  void colorsPerFaceGoByQuadrilateral() {
    Mesh mesh = grid("height", FLAT, "color", color(1, 0, 0, 0, 1, 0), "colorPerVertex", false);
    assertThat(mesh.vertexCount()).isEqualTo(8);
    for (int i = 0; i < mesh.indices().length; i++) {
      assertThat(mesh.colors()[4 * mesh.indices()[i]]).isEqualTo(i < 6 ? 1 : 0);
    }
  }

  @Test
  void creaseAngleKeepsARidgeSharp() {
    float[] ridge = {0, 2, 0, 0, 2, 0};
    assertThat(grid("height", ridge, "creaseAngle", 1.5f).vertexCount()).isEqualTo(8);
    assertThat(grid("height", ridge, "creaseAngle", 1.6f).vertexCount()).isEqualTo(6);
  }

  @Test
  void tooFewHeightsAreReportedAndDrawNothing() {
    assertThat(
            mesh(node(
                    "ElevationGrid",
                    "xDimension",
                    100_000,
                    "zDimension",
                    100_000,
                    "height",
                    new float[5]))
                .isEmpty())
        .isTrue();
    assertThat(messages())
        .containsExactly("ElevationGrid has 5 heights for 100000 x 100000 points; it is left out");
  }
}
