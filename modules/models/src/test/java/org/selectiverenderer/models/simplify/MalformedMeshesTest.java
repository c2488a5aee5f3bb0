package org.selectiverenderer.models.simplify;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.geometry.mesh.Mesh;

class MalformedMeshesTest {
  private final Simplifier simplifier = new Simplifier();

  private static Mesh raw(float[] positions, int... indices) {
    return new Mesh(
        Mesh.Primitive.TRIANGLES, positions, null, null, null, indices, true, new float[6]);
  }

  @ParameterizedTest
  @ValueSource(ints = {0, -1, Integer.MIN_VALUE})
  void aCountOfNothingIsRefused(int count) {
    assertThatIllegalArgumentException().isThrownBy(() -> new SimplificationTarget.Polygons(count));
    assertThatIllegalArgumentException().isThrownBy(() -> new SimplificationTarget.Vertices(count));
    assertThatIllegalArgumentException().isThrownBy(() -> new SimplificationTarget.Exactly(count));
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, -5, 100.1, Double.NaN, Double.POSITIVE_INFINITY})
  void aPercentageOfNothingIsRefused(double percent) {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new SimplificationTarget.VertexPercent(percent));
  }

  @Test
  void moreThanTheModelHasIsRefused() {
    List<Mesh> cube = List.of(TestMeshes.cube(1));

    assertThatIllegalArgumentException()
        .isThrownBy(() -> simplifier.simplify(cube, new SimplificationTarget.Polygons(13)))
        .withMessageContaining("12 polygons");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> simplifier.simplify(cube, new SimplificationTarget.Vertices(9)))
        .withMessageContaining("8 vertices");
  }

  @Test
  void aModelWithoutFacesIsRefused() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> simplifier.simplify(List.of(), new SimplificationTarget.Polygons(1)))
        .withMessageContaining("no polygons");
  }

  @ParameterizedTest
  @ValueSource(floats = {Float.NaN, Float.POSITIVE_INFINITY, Float.NEGATIVE_INFINITY})
  void numbersThatAreNoneAreRefused(float bad) {
    Mesh mesh = raw(new float[] {0, 0, 0, 1, bad, 0, 0, 1, 0}, 0, 1, 2);

    assertThatIllegalArgumentException()
        .isThrownBy(() -> simplifier.simplify(List.of(mesh), new SimplificationTarget.Polygons(1)));
  }

  @ParameterizedTest
  @ValueSource(ints = {-1, 3, Integer.MAX_VALUE})
  void verticesThatAreNoneNeverReachNativeCode(int bad) {
    Mesh mesh = raw(new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0}, 0, 1, bad);

    assertThatIllegalArgumentException()
        .isThrownBy(() -> simplifier.simplify(List.of(mesh), new SimplificationTarget.Polygons(1)));
  }

  @Test
  void linesAreRefused() {
    Mesh lines =
        new Mesh(
            Mesh.Primitive.LINES,
            new float[6],
            null,
            null,
            null,
            new int[] {0, 1},
            true,
            new float[6]);

    assertThatIllegalArgumentException()
        .isThrownBy(
            () -> simplifier.simplify(List.of(lines), new SimplificationTarget.Polygons(1)));
  }

  @Test
  void trianglesWithoutAreaGoFirst() {
    Mesh ball = TestMeshes.ball(9, 12);
    int[] indices = Arrays.copyOf(ball.indices(), ball.indices().length + 30);
    for (int i = ball.indices().length; i < indices.length; i += 3) {
      indices[i] = i % 7;
      indices[i + 1] = i % 5;
      indices[i + 2] = i % 5;
    }

    SimplificationResult reduced =
        simplifier.simplify(
            List.of(raw(ball.positions(), indices)), new SimplificationTarget.Polygons(100));

    assertThat(reduced.met()).isTrue();
    assertThat(TestMeshes.volume(reduced.parts().get(0))).isBetween(3.0, 4.2);
  }

  @Test
  void threeFacesOnAnEdgeAreReducedAllTheSame() {
    Mesh wall = TestMeshes.field(0, 10, (x, z) -> 0, false);
    float[] turned = wall.positions().clone();
    for (int i = 0; i < turned.length; i += 3) {
      turned[i + 1] = turned[i];
      turned[i] = 0.5f;
    }
    float[] both = Arrays.copyOf(wall.positions(), 2 * turned.length);
    System.arraycopy(turned, 0, both, turned.length, turned.length);
    int[] indices = Arrays.copyOf(wall.indices(), 2 * wall.indices().length);
    for (int i = 0; i < wall.indices().length; i++) {
      indices[wall.indices().length + i] = wall.indices()[i] + wall.vertexCount();
    }

    SimplificationResult reduced =
        simplifier.simplify(
            List.of(TestMeshes.creased(both, indices)), new SimplificationTarget.Polygons(40));

    assertThat(reduced.met()).isTrue();
    assertThat(reduced.error()).isLessThan(0.02);
  }

  @Test
  void everyFaceTwiceCountsTwice() {
    Mesh ball = TestMeshes.ball(9, 12);
    int[] twice = Arrays.copyOf(ball.indices(), 2 * ball.indices().length);
    System.arraycopy(ball.indices(), 0, twice, ball.indices().length, ball.indices().length);

    SimplificationResult reduced =
        simplifier.simplify(
            List.of(raw(ball.positions(), twice)), new SimplificationTarget.Polygons(100));

    assertThat(reduced.met()).isTrue();
  }

  @Test
  void allVerticesInOnePlaceAreRefusedOrReduced() {
    Mesh point = raw(new float[9], 0, 1, 2);

    assertThat(simplifier.simplify(List.of(point), new SimplificationTarget.Polygons(1)).polygons())
        .isLessThanOrEqualTo(1);
  }

  @Test
  void trianglesAtRandomAreReducedAsFarAsTheyGoAndThatIsSaid() {
    Random random = new Random(7);
    float[] positions = new float[600];
    for (int i = 0; i < positions.length; i++) {
      positions[i] = random.nextFloat() * (i % 5 == 0 ? 1e-3f : 1e3f);
    }
    int[] indices = random.ints(900, 0, 200).toArray();
    Mesh soup = raw(positions, indices);

    for (int polygons : new int[] {290, 150, 37, 5, 1}) {
      SimplificationResult reduced =
          simplifier.simplify(List.of(soup), new SimplificationTarget.Polygons(polygons));
      assertThat(reduced.polygons()).isBetween(1, 300);
      assertThat(reduced.met()).isEqualTo(SimplificationResult.near(reduced.polygons(), polygons));
    }
  }

  @ParameterizedTest
  @ValueSource(floats = {Float.MAX_VALUE, 1e38f, 1e30f, 1e18f, 1e-20f, 1e-40f, Float.MIN_VALUE})
  void numbersOfAnySizeEndInAModelOrAreRefused(float size) {
    Random random = new Random(3);
    float[] positions = new float[300];
    for (int i = 0; i < positions.length; i++) {
      positions[i] = (2 * random.nextFloat() - 1) * size;
    }
    List<Mesh> soup = List.of(raw(positions, random.ints(600, 0, 100).toArray()));

    for (SimplificationTarget goal :
        List.of(
            new SimplificationTarget.Polygons(20),
            new SimplificationTarget.Exactly(3),
            new SimplificationTarget.VertexPercent(10),
            new SimplificationTarget.LargestError(0.1))) {
      try {
        assertThat(simplifier.simplify(soup, goal).polygons()).isBetween(1, 200);
      } catch (IllegalArgumentException e) {
        assertThat(e.getMessage()).isNotBlank();
      }
    }
  }

  @Test
  void attributesThatAreFewerThanVerticesAreRefused() {
    Mesh mesh =
        new Mesh(
            Mesh.Primitive.TRIANGLES,
            new float[9],
            new float[6],
            null,
            null,
            new int[] {0, 1, 2},
            true,
            new float[6]);

    assertThatIllegalArgumentException()
        .isThrownBy(() -> simplifier.simplify(List.of(mesh), new SimplificationTarget.Polygons(1)))
        .withMessageContaining("attributes");
  }
}
