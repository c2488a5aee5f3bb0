package org.selectiverenderer.models.simplify;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.geometry.mesh.Mesh;

class SimplifierTest {
  private final Simplifier simplifier = new Simplifier();

  private SimplificationResult reduce(Mesh mesh, SimplificationTarget goal) {
    return simplifier.simplify(List.of(mesh), goal);
  }

  @ParameterizedTest
  @ValueSource(ints = {1000, 500, 100, 20, 4})
  void aBallMeetsItsCountAndStaysClosed(int polygons) {
    SimplificationResult reduced =
        reduce(TestMeshes.ball(29, 40), new SimplificationTarget.Polygons(polygons));

    assertThat(reduced.met()).isTrue();
    assertThat(reduced.polygons()).isCloseTo(polygons, within(Math.max(2, polygons / 100)));
    Mesh mesh = reduced.parts().get(0);
    assertThat(mesh.polygons()).isEqualTo(reduced.polygons());
    assertThat(TestMeshes.edges(mesh).values()).containsOnly(2);
  }

  @Test
  void aBallOf200PolygonsIsStillABall() {
    SimplificationResult reduced =
        reduce(TestMeshes.ball(29, 40), new SimplificationTarget.Polygons(200));

    Mesh mesh = reduced.parts().get(0);
    assertThat(TestMeshes.volume(mesh)).isCloseTo(4.0 / 3 * Math.PI, within(0.25));
    assertThat(reduced.error()).isBetween(0.001, 0.03);
    for (int v = 0; v < mesh.vertexCount(); v++) {
      double cosine = 0;
      double length = 0;
      for (int axis = 0; axis < 3; axis++) {
        double p = mesh.positions()[3 * v + axis];
        cosine += p * mesh.normals()[3 * v + axis];
        length += p * p;
      }
      assertThat(cosine / Math.sqrt(length)).isGreaterThan(0.95);
    }
  }

  @Test
  void aCubeComesDownToItsTwelveTrianglesWithoutError() {
    SimplificationResult reduced =
        reduce(TestMeshes.cube(10), new SimplificationTarget.Polygons(12));

    assertThat(reduced.polygons()).isEqualTo(12);
    assertThat(reduced.vertices()).isEqualTo(8);
    assertThat(reduced.error()).isLessThan(1e-6);
    Mesh mesh = reduced.parts().get(0);
    assertThat(TestMeshes.volume(mesh)).isCloseTo(1, within(1e-6));
    for (int v = 0; v < mesh.vertexCount(); v++) {
      float[] normal = Arrays.copyOfRange(mesh.normals(), 3 * v, 3 * v + 3);
      assertThat(Math.abs(normal[0]) + Math.abs(normal[1]) + Math.abs(normal[2]))
          .as("one axis only: the faces are shaded flat")
          .isCloseTo(1, within(1e-3f));
    }
  }

  @Test
  void aFlatPartGivesMoreThanOneWithForm() {
    Mesh flat = TestMeshes.field(0, 20, (x, z) -> 0, false);
    Mesh waves = TestMeshes.field(3, 20, (x, z) -> 0.1 * Math.sin(9 * x) * Math.sin(9 * z), false);

    SimplificationResult reduced =
        simplifier.simplify(List.of(flat, waves), new SimplificationTarget.Polygons(300));

    assertThat(reduced.met()).isTrue();
    assertThat(reduced.parts().get(0).polygons()).isLessThan(20);
    assertThat(reduced.parts().get(1).polygons()).isGreaterThan(270);
  }

  @Test
  void materialsThatMeetStillMeetWithoutAGap() {
    TestMeshes.Height hill =
        (x, z) -> 0.3 * Math.exp(-4 * ((x - 1) * (x - 1) + (z - 0.5) * (z - 0.5)));
    Mesh left = TestMeshes.field(0, 20, hill, false);
    Mesh right = TestMeshes.field(1, 20, hill, false);

    SimplificationResult reduced =
        simplifier.simplify(List.of(left, right), new SimplificationTarget.Polygons(200));

    assertThat(reduced.met()).isTrue();
    assertThat(border(reduced.parts().get(0)))
        .hasSizeGreaterThan(2)
        .containsExactlyInAnyOrderElementsOf(border(reduced.parts().get(1)));
  }

  /** The positions on the line x = 1. */
  private static List<String> border(Mesh mesh) {
    return IntStream.of(mesh.indices())
        .filter(v -> Math.abs(mesh.positions()[3 * v] - 1) < 0.01)
        .mapToObj(v -> TestMeshes.point(mesh, v))
        .distinct()
        .toList();
  }

  @Test
  void aTextureStaysWhereItWas() {
    Mesh field = TestMeshes.field(0, 24, (x, z) -> 0.1 * Math.sin(7 * x), true);

    Mesh mesh = reduce(field, new SimplificationTarget.Polygons(150)).parts().get(0);

    for (int v = 0; v < mesh.vertexCount(); v++) {
      assertThat(mesh.texCoords()[2 * v]).isCloseTo(mesh.positions()[3 * v], within(0.03f));
      assertThat(mesh.texCoords()[2 * v + 1]).isCloseTo(mesh.positions()[3 * v + 2], within(0.03f));
    }
  }

  @Test
  void whereColoursChangeTheyStillChange() {
    Mesh field = TestMeshes.field(0, 20, (x, z) -> 0, false);
    float[] colors = new float[4 * field.vertexCount()];
    for (int v = 0; v < field.vertexCount(); v++) {
      colors[4 * v + (field.positions()[3 * v] < 0.475 ? 0 : 2)] = 1;
      colors[4 * v + 3] = 1;
    }

    SimplificationResult reduced =
        reduce(TestMeshes.with(field, colors, null), new SimplificationTarget.Polygons(60));

    Mesh mesh = reduced.parts().get(0);
    for (int v = 0; v < mesh.vertexCount(); v++) {
      float x = mesh.positions()[3 * v];
      if (x < 0.4 || x > 0.55) {
        assertThat(mesh.colors()[4 * v]).isCloseTo(x < 0.475 ? 1 : 0, within(0.1f));
      }
    }
  }

  @Test
  void verticesAreDistinctPositions() {
    assertThat(ModelSize.of(List.of(TestMeshes.cube(1)))).isEqualTo(new ModelSize(8, 12));
  }

  @ParameterizedTest
  @ValueSource(ints = {600, 117, 12})
  void aNumberOfVerticesIsMet(int vertices) {
    SimplificationResult reduced =
        reduce(TestMeshes.ball(29, 40), new SimplificationTarget.Vertices(vertices));

    assertThat(reduced.met()).isTrue();
    assertThat(reduced.vertices()).isCloseTo(vertices, within(Math.max(2, vertices / 100)));
  }

  @Test
  void aNumberOfVerticesIsMetByPiecesToo() {
    List<Mesh> pieces =
        IntStream.range(0, 40)
            .mapToObj(i -> TestMeshes.field(2 * i, 2, (x, z) -> 0, false))
            .toList();

    for (int vertices : new int[] {300, 161, 77, 12}) {
      SimplificationResult reduced =
          simplifier.simplify(pieces, new SimplificationTarget.Vertices(vertices));
      assertThat(reduced.met()).as("%d vertices", vertices).isTrue();
      assertThat(ModelSize.of(reduced.parts()).vertices()).isEqualTo(reduced.vertices());
    }
  }

  @Test
  void aPercentageOfVerticesIsMet() {
    SimplificationResult reduced =
        reduce(TestMeshes.ball(29, 40), new SimplificationTarget.VertexPercent(25));

    assertThat(reduced.vertices()).isCloseTo(1162 / 4, within(3));
  }

  @Test
  void aHundredPercentIsTheModelItself() {
    Mesh ball = TestMeshes.ball(9, 12);

    SimplificationResult same = reduce(ball, new SimplificationTarget.VertexPercent(100));

    assertThat(same.error()).isZero();
    assertThat(same.polygons()).isEqualTo(ball.polygons());
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.001, 0.01, 0.1, 2})
  void anErrorIsNotExceeded(double error) {
    Mesh ball = TestMeshes.ball(29, 40);

    SimplificationResult reduced = reduce(ball, new SimplificationTarget.LargestError(error));

    assertThat(reduced.error()).isLessThanOrEqualTo(error);
    assertThat(reduced.polygons()).isBetween(1, error < 0.01 ? 2320 : 900);
  }

  /** How many polygons a ball may keep for an error. */
  @ParameterizedTest
  @CsvSource({"0.001, 1960", "0.01, 340", "0.05, 75", "0.15, 30"})
  void anErrorAllowedIsMadeUseOf(double error, int polygons) {
    SimplificationResult reduced =
        reduce(TestMeshes.ball(29, 40), new SimplificationTarget.LargestError(error));

    assertThat(reduced.error()).isLessThanOrEqualTo(error);
    assertThat(reduced.polygons()).isLessThanOrEqualTo(polygons);
  }

  /** As programs write a pole that compute sin(pi): a ring of vertices, each a hair off. */
  @Test
  void verticesThatAreNearlyTheSameCountAsOne() {
    Mesh nearly = TestMeshes.ballWithPoleOfMany(30, 40, 1e-16);
    Mesh exact = TestMeshes.ballWithPoleOfMany(30, 40, 0);

    for (int polygons : new int[] {100, 90, 80}) {
      SimplificationResult reduced = reduce(nearly, new SimplificationTarget.Polygons(polygons));
      assertThat(reduced.error())
          .as("%d polygons", polygons)
          .isLessThan(1.5 * reduce(exact, new SimplificationTarget.Polygons(polygons)).error());
    }
  }

  @Test
  void exactlyMeansExactly() {
    Mesh field = TestMeshes.field(0, 12, (x, z) -> 0.1 * Math.sin(9 * x + 5 * z), false);

    for (int polygons = 90; polygons < 100; polygons++) {
      SimplificationResult reduced = reduce(field, new SimplificationTarget.Exactly(polygons));
      assertThat(reduced.polygons()).isEqualTo(polygons);
      assertThat(reduced.met()).isTrue();
    }
  }

  @Test
  void aClosedSurfaceCannotHaveAnOddCount() {
    SimplificationResult reduced =
        reduce(TestMeshes.ball(9, 12), new SimplificationTarget.Exactly(101));

    assertThat(reduced.met()).isFalse();
    assertThat(reduced.polygons()).isIn(100, 102);
  }

  @Test
  void manyPiecesAreReducedBelowTheirNumber() {
    List<Mesh> pieces =
        IntStream.range(0, 40)
            .mapToObj(i -> TestMeshes.field(2 * i, 1, (x, z) -> 0, false))
            .toList();

    SimplificationResult reduced =
        simplifier.simplify(pieces, new SimplificationTarget.Polygons(20));

    assertThat(reduced.met()).isTrue();
    assertThat(reduced.parts()).hasSize(40).anyMatch(Mesh::isEmpty).anyMatch(m -> !m.isEmpty());
  }

  @Test
  void theSameComesOutEveryTimeOnEveryThread() {
    Mesh ball = TestMeshes.ball(20, 30);
    Mesh once = reduce(ball, new SimplificationTarget.Polygons(150)).parts().get(0);

    List<Mesh> others =
        IntStream.range(0, 8)
            .parallel()
            .mapToObj(
                i ->
                    new Simplifier()
                        .simplify(List.of(ball), new SimplificationTarget.Polygons(150)))
            .map(result -> result.parts().get(0))
            .toList();

    assertThat(others)
        .allSatisfy(
            other -> {
              assertThat(other.positions()).isEqualTo(once.positions());
              assertThat(other.normals()).isEqualTo(once.normals());
              assertThat(other.indices()).isEqualTo(once.indices());
            });
  }
}
