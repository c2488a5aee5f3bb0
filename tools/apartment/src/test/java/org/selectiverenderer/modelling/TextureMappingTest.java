package org.selectiverenderer.modelling;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.geometry.mesh.TriangleMesh;

class TextureMappingTest {
  private static final TextureMapping WALL = TextureMapping.metric("wall.png", 2, 4);

  /** Letters in the picture can be read from the side that the wall faces. */
  @Test
  void onWallsThePictureIsUpright() {
    Vector3d north = new Vector3d(0, 0, 1);
    Vector3d south = new Vector3d(0, 0, -1);
    Vector3d west = new Vector3d(1, 0, 0);
    Vector3d east = new Vector3d(-1, 0, 0);

    assertThat(at(WALL, 1, 2, 0, north)).containsExactly(0.5, 0.5);
    assertThat(at(WALL, 1, 2, 0, south)).containsExactly(-0.5, 0.5);
    assertThat(at(WALL, 0, 2, 1, west)).containsExactly(-0.5, 0.5);
    assertThat(at(WALL, 0, 2, 1, east)).containsExactly(0.5, 0.5);
  }

  @Test
  void onAFloorItBeginsWhereItIsLaid() {
    TextureMapping floor = TextureMapping.floor(-3, -5, "floor.png", 2, 2);
    Vector3d up = new Vector3d(0, 1, 0);

    assertThat(at(floor, -3, 0, -5, up)).containsExactly(0, 0);
    assertThat(at(floor, -2, 0, -6, up)).containsExactly(0.5, 0.5);
  }

  @Test
  void aQuarterIsSeenFourTimes() {
    TextureMapping carpet = TextureMapping.quarter("carpet.png", 2, 1);
    Vector3d up = new Vector3d(0, 1, 0);

    for (int x = -1; x <= 1; x += 2) {
      for (int z = -1; z <= 1; z += 2) {
        assertThat(at(carpet, 1.5 * x, 0, 0.25 * z, up)).containsExactly(0.75, 0.25);
      }
    }
  }

  /** Where a model's polygons are divided to a count, its picture does not move. */
  @Test
  void dividingTrianglesLeavesThePictureWhereItWas() {
    ModelMaterial look = ModelMaterial.matt(ModelColour.grey(1)).clad(WALL);
    TriangleMesh square = ParametricSurface.field(4, 4, 1, 1, (x, z) -> 0).turnX(90);
    ParametricModel model = ParametricModel.of("wall", Part.of("wall", look, square));

    ParametricModel divided = ExactCountRefiner.refine(model, 37);

    assertThat(divided.polygons()).isEqualTo(37);
    assertThat(divided.pictures()).containsExactly("wall.png");
    String text = new X3dModelWriter("a test").text(divided, "wall.x3d", "A wall");
    double[] points = numbers(text, "<Coordinate point='");
    double[] pairs = numbers(text, "<TextureCoordinate point='");
    double[] index = numbers(text, " coordIndex='");
    double[] pairIndex = numbers(text, "texCoordIndex='");
    assertThat(pairIndex).hasSameSizeAs(index);
    for (int i = 0; i < index.length; i++) {
      if (index[i] >= 0) {
        int point = 3 * (int) index[i];
        int pair = 2 * (int) pairIndex[i];
        assertThat(pairs[pair]).isCloseTo(points[point] / 2, within(1e-4));
        assertThat(pairs[pair + 1]).isCloseTo(points[point + 1] / 4, within(1e-4));
      }
    }
  }

  /** A cube's corner has three places of the picture, one for each face. */
  @Test
  void facesOfABoxHaveThePictureEach() {
    ModelMaterial look = ModelMaterial.matt(ModelColour.grey(1)).clad(WALL);
    ParametricModel box =
        ParametricModel.of("box", Part.of("box", look, BoxBuilder.plain(1, 1, 1)));

    String text = new X3dModelWriter("a test").text(box, "box.x3d", "A box");

    assertThat(numbers(text, "<Coordinate point='")).hasSize(3 * 8);
    assertThat(text).contains("<ImageTexture url='\"wall.png\"'>", "generateMipMaps='true'");
    double[] pairs = numbers(text, "<TextureCoordinate point='");
    for (int i = 0; i < pairs.length; i += 2) {
      assertThat(Math.abs(pairs[i])).isEqualTo(0.25);
      assertThat(pairs[i + 1]).isIn(0.0, 0.25, -0.125, 0.125);
    }
  }

  private static double[] at(
      TextureMapping cladding, double x, double y, double z, Vector3d normal) {
    double[] pair = cladding.laying().at(new Vector3d(x, y, z), normal);
    return new double[] {pair[0] + 0.0, pair[1] + 0.0};
  }

  private static double[] numbers(String text, String before) {
    String values = text.split(before, 2)[1].split("'", 2)[0];
    return java.util.Arrays.stream(values.trim().split("\\s+"))
        .mapToDouble(Double::parseDouble)
        .toArray();
  }
}
