package org.selectiverenderer.x3d.tessellate;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.x3d.catalogue.NodeView;

class TriangleSetTessellatorTest extends AbstractTessellatorTest {
  // 3 - 2 - 5
  // | / | / |
  // 0 - 1 - 4
  private static final NodeView GRID =
      coordinate(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 2, 0, 0, 2, 1, 0);

  @Test
  void indexedTrianglesShareVertices() {
    Mesh mesh =
        mesh("IndexedTriangleSet", "coord", GRID, "index", new int[] {0, 1, 2, 0, 2, 3, 1, 4, 5});
    assertThat(mesh.polygons()).isEqualTo(3);
    assertThat(mesh.vertexCount()).isEqualTo(6);
    assertThat(MeshProperties.area(mesh)).isCloseTo(1.5, within(1e-6));
  }

  @Test
  void normalPerVertexDecidesWhetherGeneratedNormalsAreSmooth() {
    NodeView roof = coordinate(0, 0, 0, 1, 0, 0, 1, 1, 1, 0, 1, 1, 0, 2, 0, 1, 2, 0);
    int[] index = {0, 1, 2, 0, 2, 3, 3, 2, 5, 3, 5, 4};
    Mesh smooth = mesh("IndexedTriangleSet", "coord", roof, "index", index);
    assertThat(smooth.vertexCount()).isEqualTo(6);
    assertThat(MeshProperties.normal(smooth, 5))
        .containsExactly(new double[] {0, 0, 1}, within(0.35));
    Mesh flat = mesh("IndexedTriangleSet", "coord", roof, "index", index, "normalPerVertex", false);
    assertThat(flat.vertexCount()).isEqualTo(8);
    MeshProperties.assertNormalsAgreeWithWinding(flat);
  }

  @Test
  void stripsAlternateTheirWinding() {
    Mesh indexed =
        mesh(
            "IndexedTriangleStripSet",
            "coord",
            GRID,
            "index",
            new int[] {3, 0, 2, 1, 5, 4, -1, 0, 1, 2});
    assertThat(indexed.polygons()).isEqualTo(5);
    MeshProperties.assertNormalsAgreeWithWinding(indexed);
    assertThat(MeshProperties.normal(indexed, 0)).containsExactly(0, 0, 1);
    Mesh plain =
        mesh(
            "TriangleStripSet",
            "coord",
            coordinate(0, 1, 0, 0, 0, 0, 1, 1, 0, 1, 0, 0, 2, 1, 0, 2, 0, 0, 3, 0, 0),
            "stripCount",
            new int[] {4, 3});
    assertThat(plain.polygons()).isEqualTo(3);
    assertThat(MeshProperties.area(plain)).isCloseTo(1.5, within(1e-6));
  }

  @Test
  void fansTurnAroundTheirFirstPoint() {
    int[] index = {0, 1, 4, 5, 2, 3};
    Mesh indexed = mesh("IndexedTriangleFanSet", "coord", GRID, "index", index);
    assertThat(indexed.polygons()).isEqualTo(3); // 0 1 4 has no area
    assertThat(MeshProperties.area(indexed)).isCloseTo(2, within(1e-6));
    Mesh plain =
        mesh(
            "TriangleFanSet",
            "coord",
            coordinate(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0),
            "fanCount",
            new int[] {4});
    assertThat(MeshProperties.area(plain)).isCloseTo(1, within(1e-6));
  }

  @Test
  void quadsAreSplitWhereTheyAreConcaveToo() {
    Mesh mesh =
        mesh(
            "QuadSet",
            "coord",
            coordinate(0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0, 0, 0, 1, 4, 0, 1, 1, 1, 1, 0, 4, 1));
    assertThat(mesh.polygons()).isEqualTo(4);
    assertThat(MeshProperties.area(mesh)).isCloseTo(4 + 4, within(1e-6));
    Mesh indexed =
        mesh("IndexedQuadSet", "coord", GRID, "index", new int[] {0, 1, 2, 3, 1, 4, 5, 2});
    assertThat(MeshProperties.area(indexed)).isCloseTo(2, within(1e-6));
    assertThat(indexed.vertexCount()).isEqualTo(6);
  }

  @Test
  void colorsPerFaceGoByTriangle() {
    Mesh mesh =
        mesh(
            "IndexedTriangleSet",
            "coord",
            GRID,
            "index",
            new int[] {0, 1, 2, 0, 2, 3},
            "color",
            color(1, 0, 0, 0, 1, 0),
            "colorPerVertex",
            false);
    assertThat(mesh.vertexCount()).isEqualTo(6);
    assertThat(mesh.colors()[4 * mesh.indices()[0]]).isEqualTo(1);
    assertThat(mesh.colors()[4 * mesh.indices()[3]]).isEqualTo(0);
  }

  @Test
  void leftOverPointsAreReported() {
    mesh(node("TriangleSet", "coord", GRID));
    assertThat(messages()).isEmpty();
    mesh(node("IndexedTriangleSet", "coord", GRID, "index", new int[] {0, 1, 2, 3}));
    mesh(node("TriangleStripSet", "coord", GRID, "stripCount", new int[] {4, 9}));
    assertThat(messages())
        .containsExactly(
            "IndexedTriangleSet has 1 extra point at its end; it is left out",
            "TriangleStripSet has a stripCount that asks for more points than there are;"
                + " the rest is left out");
  }
}
