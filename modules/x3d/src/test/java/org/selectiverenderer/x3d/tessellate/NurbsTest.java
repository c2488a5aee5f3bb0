package org.selectiverenderer.x3d.tessellate;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.read.ParsedNode;

class NurbsTest extends AbstractTessellatorTest {
  private static final float HALF = (float) Math.sqrt(0.5);

  /** The nine control points of a quarter of a sphere, as a revolved arc, homogeneous. */
  private static ParsedNode octant() {
    float[] arc = {1, 0, 1, HALF, HALF, HALF, 0, 1, 1}; // x, y, weight, homogeneous
    float[] points = new float[27];
    double[] weights = new double[9];
    for (int j = 0; j < 3; j++) {
      for (int i = 0; i < 3; i++) {
        int at = 3 * j + i;
        // Turned about the y axis by the same arc; the weights multiply.
        points[3 * at] = arc[3 * i] * arc[3 * j];
        points[3 * at + 1] = arc[3 * i + 1] * arc[3 * j + 2];
        points[3 * at + 2] = arc[3 * i] * arc[3 * j + 1];
        weights[at] = arc[3 * i + 2] * arc[3 * j + 2];
      }
    }
    double[] knots = {0, 0, 0, 1, 1, 1};
    return node(
        "NurbsPatchSurface",
        "uDimension",
        3,
        "vDimension",
        3,
        "uKnot",
        knots,
        "vKnot",
        knots,
        "uTessellation",
        8,
        "vTessellation",
        8,
        "weight",
        weights,
        "controlPoint",
        coordinate(points));
  }

  @Test
  void weightedPointsMakeAnExactCircle() {
    Mesh mesh =
        mesh(
            "NurbsCurve",
            "tessellation",
            16,
            "weight",
            new double[] {1, HALF, 1},
            "controlPoint",
            coordinate(2, 0, 0, 2 * HALF, 2 * HALF, 0, 0, 2, 0));

    assertThat(mesh.vertexCount()).isEqualTo(17);
    for (int i = 0; i < 17; i++) {
      assertThat(Math.hypot(mesh.positions()[3 * i], mesh.positions()[3 * i + 1]))
          .isEqualTo(2, within(1e-6));
    }
  }

  @Test
  void anEighthOfASphereHasTheSpheresPointsAndNormals() {
    Mesh mesh = mesh(octant());

    assertThat(messages()).isEmpty();
    assertThat(mesh.polygons()).isEqualTo(2 * 8 * 8 - 8); // One edge is drawn together to the pole.
    for (int i = 0; i < mesh.vertexCount(); i++) {
      Vector3d point = vector(mesh.positions(), i);
      assertThat(point.length()).isEqualTo(1, within(1e-6));
      assertThat(Math.abs(vector(mesh.normals(), i).dot(point))).isEqualTo(1, within(1e-4));
    }
  }

  private static Vector3d vector(float[] values, int i) {
    return new Vector3d(values[3 * i], values[3 * i + 1], values[3 * i + 2]);
  }

  @Test
  void tessellationSaysIntoHowManyParts() {
    NodeView points = coordinate(0, 0, 0, 1, 0, 0, 2, 1, 0, 3, 0, 0);

    assertThat(mesh("NurbsCurve", "controlPoint", points).vertexCount()).isEqualTo(9);
    assertThat(mesh("NurbsCurve", "controlPoint", points, "tessellation", -5).vertexCount())
        .isEqualTo(21);
    assertThat(mesh("NurbsCurve", "controlPoint", points, "tessellation", 3).vertexCount())
        .isEqualTo(4);
  }

  @Test
  void aClosedCurveWithoutKnotsIsSmoothWhereItCloses() {
    Mesh mesh =
        mesh(
            "NurbsCurve",
            "closed",
            true,
            "tessellation",
            40,
            "controlPoint",
            coordinate(1, 1, 0, -1, 1, 0, -1, -1, 0, 1, -1, 0, 1, 1, 0));

    Vector3d first = vector(mesh.positions(), 0);
    Vector3d last = vector(mesh.positions(), mesh.indices()[mesh.indices().length - 1]);
    assertThat(first.distance(last)).isEqualTo(0, within(1e-6));
    Vector3d leaving = vector(mesh.positions(), 1).sub(first);
    Vector3d arriving = last.sub(vector(mesh.positions(), mesh.vertexCount() - 2));
    if (arriving.length() < 1e-6) {
      arriving = vector(mesh.positions(), 0).sub(vector(mesh.positions(), mesh.vertexCount() - 1));
    }
    assertThat(leaving.angle(arriving)).isLessThan(0.2);
  }

  @Test
  void aSurfaceLosesTheAreaThatIsTrimmedAway() {
    NodeView outer = node("ContourPolyline2D", "controlPoint", square(0.1, 0.9));
    NodeView hole = node("ContourPolyline2D", "controlPoint", square(0.4, 0.6));
    Mesh mesh =
        mesh(
            "NurbsTrimmedSurface",
            "uOrder",
            2,
            "vOrder",
            2,
            "uDimension",
            2,
            "vDimension",
            2,
            "uTessellation",
            7,
            "vTessellation",
            5,
            "controlPoint",
            coordinate(0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0),
            "trimmingContour",
            List.of(
                node("Contour2D", "children", List.of(outer)),
                node("Contour2D", "children", List.of(hole))));

    double area = 0;
    for (int i = 0; i < mesh.indices().length; i += 3) {
      Vector3d a = vector(mesh.positions(), mesh.indices()[i]);
      Vector3d b = vector(mesh.positions(), mesh.indices()[i + 1]).sub(a);
      Vector3d c = vector(mesh.positions(), mesh.indices()[i + 2]).sub(a);
      area += b.cross(c).z / 2;
    }
    assertThat(area).isEqualTo(0.64 - 0.04, within(1e-6));
  }

  private static double[] square(double from, double to) {
    return new double[] {from, from, to, from, to, to, from, to, from, from};
  }

  @Test
  void whatCannotBeDrawnIsSaid() {
    mesh(node("NurbsCurve", "order", 9, "controlPoint", coordinate(0, 0, 0, 1, 0, 0)));
    mesh(
        node(
            "NurbsPatchSurface",
            "uDimension",
            9,
            "vDimension",
            9,
            "controlPoint",
            coordinate(1, 2, 3)));

    assertThat(messages().get(0)).contains("order 9").contains("left out");
    assertThat(messages().get(1)).contains("1 control points, too few for its dimensions 9 x 9");
  }
}
