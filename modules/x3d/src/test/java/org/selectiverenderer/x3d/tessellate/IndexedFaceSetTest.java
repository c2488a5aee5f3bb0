package org.selectiverenderer.x3d.tessellate;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.x3d.catalogue.NodeView;

class IndexedFaceSetTest extends AbstractTessellatorTest {
  private static final float[] CUBE = {
    -1, -1, -1, 1, -1, -1, 1, 1, -1, -1, 1, -1, -1, -1, 1, 1, -1, 1, 1, 1, 1, -1, 1, 1
  };
  private static final int[] CUBE_FACES = {
    4, 5, 6, 7, -1, 1, 0, 3, 2, -1, 5, 1, 2, 6, -1, 0, 4, 7, 3, -1, 7, 6, 2, 3, -1, 0, 1, 5, 4
  };

  private Mesh cube(Object... more) {
    Object[] fields = {"coord", coordinate(CUBE), "coordIndex", CUBE_FACES};
    Object[] all = Arrays.copyOf(fields, fields.length + more.length);
    System.arraycopy(more, 0, all, fields.length, more.length);
    return mesh("IndexedFaceSet", all);
  }

  @Test
  void flatCubeHasThreeVerticesPerCorner() {
    Mesh cube = cube();
    assertThat(cube.polygons()).isEqualTo(12);
    assertThat(cube.vertexCount()).isEqualTo(24);
    assertThat(MeshProperties.volume(cube)).isCloseTo(8, within(1e-6));
    assertThat(MeshProperties.euler(cube)).isEqualTo(2);
    MeshProperties.assertNormalsAgreeWithWinding(cube);
  }

  @Test
  void creaseAngleBelowTheEdgesOfACubeLeavesThemSharp() {
    assertThat(cube("creaseAngle", 1.5f).vertexCount()).isEqualTo(24);
  }

  @Test
  void creaseAngleAboveTheEdgesOfACubeSmoothsThem() {
    for (float angle : new float[] {1.6f, 3.0f, 3.14159f, 100f}) {
      Mesh cube = cube("creaseAngle", angle);
      assertThat(cube.vertexCount()).isEqualTo(8);
      double third = Math.sqrt(1.0 / 3);
      for (int i = 0; i < cube.indices().length; i++) {
        double[] point = MeshProperties.point(cube, i);
        // Weighting by angle makes it the diagonal, however the squares are split.
        assertThat(MeshProperties.normal(cube, i))
            .containsExactly(
                new double[] {point[0] * third, point[1] * third, point[2] * third}, within(1e-4));
      }
    }
  }

  @Test
  void clockwiseFacesAreTurnedRound() {
    Mesh cube = cube("ccw", false, "solid", false);
    assertThat(MeshProperties.volume(cube)).isCloseTo(-8, within(1e-6));
    MeshProperties.assertNormalsAgreeWithWinding(cube);
    assertThat(cube.solid()).isFalse();
  }

  @Test
  void smoothFacesGivenOncePerSideKeepTheirSides() {
    Mesh both =
        mesh(
            "IndexedFaceSet",
            "coord",
            coordinate(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0),
            "coordIndex",
            new int[] {0, 1, 2, -1, 0, 2, 3, -1, 2, 1, 0, -1, 3, 2, 0, -1},
            "creaseAngle",
            3.2f);
    assertThat(both.vertexCount()).isEqualTo(8);
    MeshProperties.assertNormalsAgreeWithWinding(both);
  }

  @Test
  void concaveFaceIsClippedWhateverConvexSays() {
    for (boolean convex : new boolean[] {true, false}) {
      Mesh l =
          mesh(
              "IndexedFaceSet",
              "coord",
              coordinate(0, 0, 0, 3, 0, 0, 3, 1, 0, 1, 1, 0, 1, 3, 0, 0, 3, 0),
              "coordIndex",
              new int[] {4, 5, 0, 1, 2, 3, -1},
              "convex",
              convex);
      assertThat(MeshProperties.area(l)).isCloseTo(5, within(1e-6));
      assertThat(l.polygons()).isEqualTo(4);
      assertThat(l.vertexCount()).isEqualTo(6);
      assertThat(MeshProperties.normal(l, 0)).containsExactly(0, 0, 1);
      MeshProperties.assertNormalsAgreeWithWinding(l);
    }
  }

  @Test
  void concaveFaceSeenFromBehindKeepsItsWinding() {
    for (int axis = 0; axis < 3; axis++) {
      float[] point = new float[18];
      float[] plane = {0, 3, 1, 3, 1, 1, 3, 1, 3, 0, 0, 0};
      for (int i = 0; i < 6; i++) {
        point[3 * i + axis] = plane[2 * i];
        point[3 * i + (axis + 1) % 3] = plane[2 * i + 1];
      }
      Mesh l =
          mesh(
              "IndexedFaceSet",
              "coord",
              coordinate(point),
              "coordIndex",
              new int[] {0, 1, 2, 3, 4, 5});
      assertThat(MeshProperties.area(l)).isCloseTo(5, within(1e-6));
      assertThat(MeshProperties.normal(l, 0)[(axis + 2) % 3]).isEqualTo(-1);
      MeshProperties.assertNormalsAgreeWithWinding(l);
    }
  }

  @Test
  void colorsPerFaceAreTheFacesOwn() {
    NodeView colors = color(1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 0, 0, 1, 1, 1, 0, 1);
    Mesh direct = cube("color", colors, "colorPerVertex", false, "creaseAngle", 3f);
    assertThat(colorOf(direct, 0)).containsExactly(1, 0, 0, 1);
    assertThat(colorOf(direct, 5)).containsExactly(1, 0, 1, 1);
    assertThat(direct.vertexCount()).isEqualTo(24);
    Mesh indexed =
        cube("color", colors, "colorPerVertex", false, "colorIndex", new int[] {5, 4, 3, 2, 1, 0});
    assertThat(colorOf(indexed, 0)).containsExactly(1, 0, 1, 1);
    assertThat(colorOf(indexed, 5)).containsExactly(1, 0, 0, 1);
  }

  @Test
  void colorsPerVertexFollowTheirOwnIndex() {
    int[] colorIndex = CUBE_FACES.clone();
    for (int i = 0; i < colorIndex.length; i++) {
      colorIndex[i] = colorIndex[i] == -1 ? -1 : colorIndex[i] / 4;
    }
    Mesh cube = cube("color", color(1, 0, 0, 0, 0, 1), "colorIndex", colorIndex);
    for (int i = 0; i < cube.indices().length; i++) {
      float blue = cube.colors()[4 * cube.indices()[i] + 2];
      assertThat((double) blue).isEqualTo(MeshProperties.point(cube, i)[2] > 0 ? 1 : 0);
    }
  }

  @Test
  void colorRgbaKeepsItsAlpha() {
    float[] rgba = new float[32];
    Arrays.fill(rgba, 0.25f);
    Mesh cube = cube("color", node("ColorRGBA", "color", rgba));
    assertThat(cube.colors()).containsOnly(0.25f);
  }

  @Test
  void tooFewColorsAreReportedAndLeftOut() {
    Mesh mesh =
        mesh(
            node(
                "IndexedFaceSet",
                "coord",
                coordinate(CUBE),
                "coordIndex",
                CUBE_FACES,
                "color",
                color(1, 0, 0)));
    assertThat(mesh.colors()).isNull();
    assertThat(mesh.polygons()).isEqualTo(12);
    assertThat(messages())
        .containsExactly("IndexedFaceSet has too few colors for its faces; they are left out");
  }

  @Test
  void givenNormalsAreUsedAsUnitVectors() {
    Mesh perFace =
        mesh(
            "IndexedFaceSet",
            "coord",
            coordinate(0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0),
            "coordIndex",
            new int[] {0, 1, 2, -1, 2, 1, 3},
            "normal",
            node("Normal", "vector", new float[] {0, 0, 5, 0, 3, 4}),
            "normalPerVertex",
            false,
            "normalIndex",
            new int[] {1, 0});
    assertThat(MeshProperties.normal(perFace, 0))
        .containsExactly(new double[] {0, 0.6, 0.8}, within(1e-6));
    assertThat(MeshProperties.normal(perFace, 3)).containsExactly(0, 0, 1);
    assertThat(perFace.vertexCount()).isEqualTo(6);
  }

  @Test
  void normalWithoutDirectionIsReplacedByTheFaces() {
    Mesh mesh =
        mesh(
            node(
                "IndexedFaceSet",
                "coord",
                coordinate(0, 0, 0, 1, 0, 0, 0, 1, 0),
                "coordIndex",
                new int[] {0, 1, 2, -1},
                "normal",
                node("Normal", "vector", new float[] {0, 1, 0, 0, 0, 0, Float.NaN, 0, 0})));
    assertThat(MeshProperties.normal(mesh, 0)).containsExactly(0, 1, 0);
    assertThat(MeshProperties.normal(mesh, 1)).containsExactly(0, 0, 1);
    assertThat(MeshProperties.normal(mesh, 2)).containsExactly(0, 0, 1);
    assertThat(messages()).hasSize(1);
  }

  @Test
  void defaultTextureRunsAlongTheLongestSides() {
    Mesh mesh =
        mesh(
            "IndexedFaceSet",
            "coord",
            coordinate(1, 2, 3, 1, 2, 7, 1, 4, 7, 1, 4, 3),
            "coordIndex",
            new int[] {0, 1, 2, 3, -1});
    assertThat(mesh.texCoords()).containsExactly(0, 0, 1, 0, 1, 0.5f, 0, 0.5f);
    Mesh tie =
        mesh(
            "IndexedFaceSet",
            "coord",
            coordinate(0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0),
            "coordIndex",
            new int[] {0, 1, 2, 3, -1});
    assertThat(tie.texCoords()).containsExactly(0, 0, 1, 0, 1, 1, 0, 1);
  }

  @Test
  void textureCoordinatesFollowTheirOwnIndex() {
    NodeView texCoord =
        node("TextureCoordinate", "point", new float[] {0, 0, 4, 0, 4, 4, 0, 4, 9, 9});
    NodeView multi =
        node(
            "MultiTextureCoordinate",
            "texCoord",
            java.util.List.of(texCoord, node("TextureCoordinate")));
    Mesh mesh =
        mesh(
            "IndexedFaceSet",
            "coord",
            coordinate(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0),
            "coordIndex",
            new int[] {0, 1, 2, 3, -1},
            "texCoord",
            multi,
            "texCoordIndex",
            new int[] {3, 2, 1, 0, -1});
    assertThat(mesh.texCoords()).containsExactly(0, 4, 4, 4, 4, 0, 0, 0);
  }

  @Test
  void pointsWrittenTwiceBecomeOneVertexWhenAllElseIsEqual() {
    Mesh mesh =
        mesh(
            "IndexedFaceSet",
            "coord",
            coordinate(0, 0, 0, 1, 0, 0, 1, 1, 0, -0.0f, 0, 0, 1, 1, 0, 0, 1, 0),
            "coordIndex",
            new int[] {0, 1, 2, -1, 3, 4, 5, -1});
    assertThat(mesh.vertexCount()).isEqualTo(4);
    assertThat(mesh.polygons()).isEqualTo(2);
  }

  @Test
  void unusedPointsAreNotKept() {
    Mesh mesh =
        mesh(
            "IndexedFaceSet",
            "coord",
            coordinate(9, 9, 9, 0, 0, 0, 1, 0, 0, 8, 8, 8, 0, 1, 0),
            "coordIndex",
            new int[] {1, 2, 4});
    assertThat(mesh.vertexCount()).isEqualTo(3);
    assertThat(mesh.bounds()).containsExactly(0, 0, 0, 1, 1, 0);
  }

  @Test
  void facesThatCannotBeDrawnAreLeftOutAndReportedOnce() {
    NodeView bad =
        node(
            "IndexedFaceSet",
            "coord",
            coordinate(0, 0, 0, 1, 0, 0, 1, 1, 0, Float.NaN, 0, 0),
            "coordIndex",
            new int[] {0, 1, 2, -1, 0, 1, 9, -1, 0, 1, -7, -1, 0, 1, 3, -1, 0, 1, -1, -1});
    assertThat(mesh(bad).polygons()).isEqualTo(1);
    assertThat(messages())
        .containsExactly(
            "IndexedFaceSet refers to point index 9, but the number of points is 4; 2 faces are"
                + " left out",
            "IndexedFaceSet has points that are not finite; 1 face is left out",
            "IndexedFaceSet has a face with fewer than 3 points; 2 faces are left out");
    assertThat(problems.list().get(0).toString()).startsWith("test.x3d:1:1: ");
  }

  @Test
  void degenerateFacesAreLeftOutSilentlyButCounted() {
    NodeView node =
        node(
            "IndexedFaceSet",
            "coord",
            coordinate(0, 0, 0, 1, 0, 0, 1, 1, 0, 0.1f, 0.1f, 0.1f, 0.7f, 0.7f, 0.7f),
            "coordIndex",
            new int[] {0, 1, 2, -1, 0, 1, 1, -1, 0, 3, 4, -1});
    Tessellator.Tessellation tessellation = tessellator.examine(node, problems).orElseThrow();
    assertThat(tessellation.degenerateFaces()).isEqualTo(2);
    assertThat(tessellation.mesh().polygons()).isEqualTo(1);
    assertThat(problems.list()).isEmpty();
  }

  @Test
  void doubleCoordinatesAreDrawnToo() {
    NodeView coord = node("CoordinateDouble", "point", new double[] {0, 0, 0, 1, 0, 0, 0, 2, 0});
    Mesh mesh = mesh("IndexedFaceSet", "coord", coord, "coordIndex", new int[] {0, 1, 2});
    assertThat(MeshProperties.area(mesh)).isEqualTo(1);
  }

  @Test
  void nothingGivenIsAnEmptyMeshWithoutAProblem() {
    assertThat(mesh("IndexedFaceSet").isEmpty()).isTrue();
    assertThat(mesh("IndexedFaceSet", "coord", coordinate()).isEmpty()).isTrue();
  }

  @Test
  void arraysOfTheFileAreSharedNotCopiedWhenTheyFit() {
    float[] points = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    float[] normals = {0, 0, 1, 0, 0, 1, 0, 0, 1};
    Mesh mesh =
        tessellator
            .tessellate(
                node(
                    "IndexedTriangleSet",
                    "coord",
                    coordinate(points),
                    "index",
                    new int[] {0, 1, 2},
                    "normal",
                    node("Normal", "vector", normals)),
                new ProblemCollector())
            .orElseThrow();
    assertThat(mesh.positions()).isSameAs(points);
    assertThat(mesh.normals()).isSameAs(normals);
  }

  @Test
  void pointsOfALargeMeshAreSharedThoughAFewAreEqual() {
    float[] points = cylinder(60, 40);
    float[] normals = points.clone();
    for (int i = 1; i < normals.length; i += 3) {
      normals[i] = 0;
    }
    Mesh mesh =
        mesh(
            "IndexedFaceSet",
            "coord",
            coordinate(points),
            "coordIndex",
            gridIndices(60, 40),
            "normal",
            node("Normal", "vector", normals));
    assertThat(mesh.positions()).isSameAs(points);
    // the seam is still closed: its second points are drawn by the first ones
    for (int index : mesh.indices()) {
      assertThat(index % 61).isLessThan(60);
    }
    assertThat(MeshProperties.euler(mesh)).isZero();
    MeshProperties.assertNormalsAgreeWithWinding(mesh);
  }

  /** Points of a tube; the last column repeats the first one. */
  private static float[] cylinder(int columns, int rows) {
    float[] points = new float[3 * (columns + 1) * (rows + 1)];
    for (int row = 0, at = 0; row <= rows; row++) {
      for (int column = 0; column <= columns; column++) {
        double angle = 2 * Math.PI * (column % columns) / columns;
        points[at++] = (float) Math.sin(angle);
        points[at++] = row / 10f;
        points[at++] = (float) Math.cos(angle);
      }
    }
    return points;
  }

  private static int[] gridIndices(int columns, int rows) {
    return IntStream.range(0, columns * rows)
        .flatMap(
            i -> {
              int a = i / columns * (columns + 1) + i % columns;
              return IntStream.of(a, a + 1, a + columns + 2, a + columns + 1, -1);
            })
        .toArray();
  }

  /** The colour of the triangles of a face of the cube. */
  private static float[] colorOf(Mesh cube, int face) {
    int vertex = cube.indices()[6 * face];
    return Arrays.copyOfRange(cube.colors(), 4 * vertex, 4 * vertex + 4);
  }

  private Mesh face(float[] xyz) {
    int[] face = IntStream.range(0, xyz.length / 3).toArray();
    return mesh(node("IndexedFaceSet", "coord", coordinate(xyz), "coordIndex", face));
  }

  @Test
  void aLargeFaceThatCrossesItselfIsFilledAsAFanAndReported() {
    Random random = new Random(1);
    float[] xyz = new float[3 * 20_000];
    for (int i = 0; i < xyz.length; i += 3) {
      xyz[i] = random.nextFloat();
      xyz[i + 1] = random.nextFloat();
    }
    assertThat(face(xyz).polygons()).isPositive();
    assertThat(messages())
        .containsExactly(
            "IndexedFaceSet has a face of more than 256 points that intersect themselves; they are"
                + " filled roughly");
  }

  @Test
  void aLargeFaceThatDoesNotCrossItselfIsClipped() {
    float[] xyz = new float[3 * 6000];
    double[] radii = {1, 0.9, 0.2};
    for (int i = 0; i < 6000; i++) {
      double angle = 2 * Math.PI * i / 6000;
      xyz[3 * i] = (float) (radii[i % 3] * Math.cos(angle));
      xyz[3 * i + 1] = (float) (radii[i % 3] * Math.sin(angle));
    }
    double area = 1000 * (0.9 + 0.18 + 0.2) * Math.sin(2 * Math.PI / 6000);
    assertThat(MeshProperties.area(face(xyz))).isCloseTo(area, within(1e-4));
    assertThat(messages()).isEmpty();
  }
}
