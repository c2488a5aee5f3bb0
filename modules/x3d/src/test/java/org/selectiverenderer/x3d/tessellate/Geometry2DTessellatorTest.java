package org.selectiverenderer.x3d.tessellate;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.selectiverenderer.geometry.mesh.Mesh;

class Geometry2DTessellatorTest extends AbstractTessellatorTest {
  private static final double CIRCLE = 32 * Math.sin(Math.PI / 32);

  @Test
  void shapesHaveTheirAreasAndFaceTheViewer() {
    assertArea(mesh("Rectangle2D", "size", new float[] {3, 2}), 6);
    assertArea(mesh("Disk2D", "outerRadius", 2f), 4 * CIRCLE);
    assertArea(mesh("Disk2D", "outerRadius", 2f, "innerRadius", 1f), 3 * CIRCLE);
    assertArea(mesh("ArcClose2D"), CIRCLE / 4);
    assertArea(mesh("ArcClose2D", "closureType", "CHORD"), CIRCLE / 4 - 0.5);
    assertArea(mesh("ArcClose2D", "endAngle", 0f), CIRCLE);
    assertArea(
        mesh("TriangleSet2D", "vertices", new float[] {0, 0, 2, 0, 0, 1, 0, 0, 0, -1, -2, 0}), 2);
  }

  private static void assertArea(Mesh mesh, double area) {
    assertThat(MeshProperties.area(mesh)).isCloseTo(area, within(1e-5));
    for (int i = 0; i < mesh.indices().length; i++) {
      assertThat(MeshProperties.normal(mesh, i)).containsExactly(0, 0, 1);
      assertThat(MeshProperties.cross(mesh, i - i % 3)[2]).isPositive();
    }
  }

  @Test
  void linesFollowTheirCurves() {
    assertThat(mesh("Circle2D", "radius", 2f).indices()).hasSize(128);
    Mesh arc = mesh("Arc2D", "radius", 2f);
    assertThat(arc.bounds()).containsExactly(new float[] {0, 0, 0, 2, 2, 0}, within(1e-5f));
    assertThat(mesh("Arc2D", "startAngle", 1f, "endAngle", 1f).indices()).hasSize(128);
    assertThat(mesh("Polyline2D", "lineSegments", new float[] {0, 0, 1, 0, 1, 1}).indices())
        .containsExactly(0, 1, 1, 2);
    assertThat(mesh("Polypoint2D", "point", new float[] {0, 0, 1, 0}).vertexCount()).isEqualTo(2);
    assertThat(mesh("Polyline2D").isEmpty()).isTrue();
  }
}
