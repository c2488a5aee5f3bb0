package org.selectiverenderer.radiosity;

import static org.assertj.core.api.Assertions.assertThat;
import static org.selectiverenderer.radiosity.SmallScene.room;

import java.util.Locale;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.radiosity.bake.TexelScene;
import org.selectiverenderer.radiosity.scene.LightScene;
import org.selectiverenderer.radiosity.work.WorkProgress;

/** Switching an object changes its outline and not its light. */
class VersionsLitAlikeTest {
  private static final RadiositySettings QUICK =
      new RadiositySettings(
              20,
              95,
              OptionalDouble.empty(),
              OptionalDouble.of(0.6),
              true,
              true,
              true,
              16,
              1,
              0,
              300_000)
          .with(new LightStore(LightStore.Kind.TEXTURES, OptionalDouble.of(20), 8, false));

  private static String shape(String geometry) {
    return "<Shape><Appearance><Material diffuseColor='0.7 0.6 0.4'/></Appearance>"
        + geometry
        + "</Shape>";
  }

  /** A face of a box around the origin: a grid from a corner along two edges. */
  private static String face(int columns, int rows, Vector3d from, Vector3d along, Vector3d up) {
    StringBuilder points = new StringBuilder();
    StringBuilder indices = new StringBuilder();
    for (int j = 0; j <= rows; j++) {
      for (int i = 0; i <= columns; i++) {
        Vector3d p = new Vector3d(from).fma((double) i / columns, along).fma((double) j / rows, up);
        points.append(String.format(Locale.ROOT, "%.6f %.6f %.6f, ", p.x, p.y, p.z));
        if (i < columns && j < rows) {
          int a = j * (columns + 1) + i;
          int b = a + columns + 1;
          indices.append("%d %d %d %d %d %d ".formatted(a, a + 1, b + 1, a, b + 1, b));
        }
      }
    }
    return shape(
        "<IndexedTriangleSet index='%s'><Coordinate point='%s'/></IndexedTriangleSet>"
            .formatted(indices, points));
  }

  /** The top of a table of 900 polygons, a hair larger than that of 12. */
  private static String fineTop() {
    double x = 0.505;
    double y = 0.021;
    double z = 0.305;
    Vector3d wide = new Vector3d(2 * x, 0, 0);
    Vector3d high = new Vector3d(0, 2 * y, 0);
    Vector3d deep = new Vector3d(0, 0, 2 * z);
    Vector3d back = new Vector3d(-x, y, z);
    return "<Group>"
        + face(18, 12, back, wide, new Vector3d(deep).negate())
        + face(18, 12, new Vector3d(-x, -y, -z), wide, deep)
        + face(6, 1, new Vector3d(-x, -y, z), wide, high)
        + face(6, 1, new Vector3d(x, -y, -z), new Vector3d(wide).negate(), high)
        + face(3, 1, new Vector3d(x, -y, z), new Vector3d(deep).negate(), high)
        + face(3, 1, new Vector3d(-x, -y, -z), deep, high)
        + "</Group>";
  }

  private static TexelScene lit(String body) throws Exception {
    LightScene scene = SmallScene.read(body);
    int[] fileOf = IntStream.range(0, scene.bodies().size()).toArray();
    return new TexelRadiosity(QUICK, WorkProgress.NONE, new Problems())
        .light(scene, fileOf, solution -> {});
  }

  @Test
  void aTableOfTwelvePolygonsHasTheShadowsOfOneOfNineHundred() throws Exception {
    String table =
        "<Transform translation='2 0.7 2'><Switch whichChoice='1'>"
            + shape("<Box size='1 0.04 0.6'/>")
            + fineTop()
            + "</Switch></Transform>";
    String cup =
        "<Transform translation='2.1 0.775 2'>"
            + shape("<Cylinder radius='0.04' height='0.1'/>")
            + "</Transform>";
    String lamp = "<SpotLight location='1.2 3 2' direction='0 -1 0' cutOffAngle='1.5'/>";
    TexelScene lit = lit(room(0, 0, 0, 4, "diffuseColor='0.8 0.8 0.8'") + table + cup + lamp);
    assertThat(lit.scene().bodies().stream().filter(b -> b.version() == 1).findFirst())
        .get()
        .extracting(b -> b.triangles())
        .isEqualTo(12);
    VersionPictures.Difference difference =
        new VersionPictures(lit)
            .compare(1, 2, new Vector3d(2.4, 1.5, 3.2), new Vector3d(2, 0.7, 2), 120);
    assertThat(difference.pixels()).isGreaterThan(3_000);
    assertThat(difference.mean()).isLessThan(1.0 / 255);
    // The shadow's edge is in the same place; the rims are a hair apart.
    assertThat(difference.far()).isLessThan(0.02);
  }
}
