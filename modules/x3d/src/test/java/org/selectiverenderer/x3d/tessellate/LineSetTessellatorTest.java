package org.selectiverenderer.x3d.tessellate;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.x3d.catalogue.NodeView;

class LineSetTessellatorTest extends AbstractTessellatorTest {
  private static final NodeView COORD = coordinate(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0);

  @Test
  void polylinesBecomeSegments() {
    Mesh mesh = mesh("IndexedLineSet", "coord", COORD, "coordIndex", new int[] {0, 1, 2, -1, 2, 3});
    assertThat(mesh.primitive()).isEqualTo(Mesh.Primitive.LINES);
    assertThat(mesh.indices()).containsExactly(0, 1, 1, 2, 2, 3);
    assertThat(mesh.normals()).isNull();
    assertThat(mesh.polygons()).isZero();
    assertThat(mesh("LineSet", "coord", COORD, "vertexCount", new int[] {2, 2}).indices())
        .containsExactly(0, 1, 2, 3);
  }

  @Test
  void colorsGoByPolylineOrByPoint() {
    NodeView colors = color(1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1);
    int[] index = {0, 1, -1, 1, 2, -1};
    Mesh byLine =
        mesh(
            "IndexedLineSet",
            "coord",
            COORD,
            "coordIndex",
            index,
            "color",
            colors,
            "colorPerVertex",
            false,
            "colorIndex",
            new int[] {1, 0});
    assertThat(byLine.vertexCount()).isEqualTo(4);
    assertThat(byLine.colors()[0]).isEqualTo(0);
    assertThat(byLine.colors()[12]).isEqualTo(1);
    Mesh byPoint = mesh("IndexedLineSet", "coord", COORD, "coordIndex", index, "color", colors);
    assertThat(byPoint.vertexCount()).isEqualTo(3);
    assertThat(byPoint.colors()).startsWith(1, 0, 0, 1, 0, 1, 0, 1);
  }

  @Test
  void pointsKeepTheirColorsAndLoseWhatIsNotFinite() {
    Mesh mesh =
        mesh(
            node(
                "PointSet",
                "coord",
                coordinate(0, 0, 0, Float.NaN, 0, 0, 1, 1, 0),
                "color",
                color(1, 0, 0, 0, 1, 0, 0, 0, 1)));
    assertThat(mesh.primitive()).isEqualTo(Mesh.Primitive.POINTS);
    assertThat(mesh.colors()).containsExactly(1, 0, 0, 1, 0, 0, 1, 1);
    assertThat(messages())
        .containsExactly("PointSet has points that are not finite; 1 point is left out");
  }

  @Test
  void linesOfOnePointAreReported() {
    assertThat(
            mesh(node("IndexedLineSet", "coord", COORD, "coordIndex", new int[] {0, -1, 7, 1}))
                .isEmpty())
        .isTrue();
    assertThat(messages()).hasSize(2);
  }
}
