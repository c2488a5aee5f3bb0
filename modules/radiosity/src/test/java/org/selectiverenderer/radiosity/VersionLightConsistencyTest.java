package org.selectiverenderer.radiosity;

import static org.assertj.core.api.Assertions.assertThat;
import static org.selectiverenderer.radiosity.TestScenes.room;

import java.util.Locale;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.radiosity.bake.LightmappedScene;
import org.selectiverenderer.radiosity.parallel.RadiosityProgress;
import org.selectiverenderer.radiosity.scene.RadiosityScene;

/** Switching an object changes its outline and not its light. */
class VersionLightConsistencyTest {
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
          300_000,
          new LightStorageSettings(
              LightStorageSettings.Kind.TEXTURES, OptionalDouble.of(20), 8, false));

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

  private static LightmappedScene lit(String body) throws Exception {
    RadiosityScene scene = TestScenes.read(body);
    int[] fileOf = IntStream.range(0, scene.bodies().size()).toArray();
    return new LightmapBaker(QUICK, RadiosityProgress.NONE, new ProblemCollector())
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
    LightmappedScene lit = lit(room(0, 0, 0, 4, "diffuseColor='0.8 0.8 0.8'") + table + cup + lamp);
    assertThat(lit.scene().bodies().stream().filter(b -> b.version() == 1).findFirst())
        .get()
        .extracting(b -> b.triangles())
        .isEqualTo(12);
    VersionRayRenderer.Difference difference =
        new VersionRayRenderer(lit)
            .compare(1, 2, new Vector3d(2.4, 1.5, 3.2), new Vector3d(2, 0.7, 2), 120);
    assertThat(difference.pixels()).isGreaterThan(3_000);
    assertThat(difference.mean()).isLessThan(1.0 / 255);
    // The shadow's edge is in the same place; the rims are a hair apart.
    assertThat(difference.far()).isLessThan(0.02);
  }

  /**
   * A surface around the y axis.
   *
   * @param profile radius and height of its rings, the outside on the left of the way along them
   */
  private static String turned(int sides, boolean solid, double... profile) {
    StringBuilder points = new StringBuilder();
    StringBuilder indices = new StringBuilder();
    for (int ring = 0; ring < profile.length / 2; ring++) {
      for (int side = 0; side < sides; side++) {
        double angle = 2 * Math.PI * side / sides;
        double x = profile[2 * ring] * Math.cos(angle);
        double z = profile[2 * ring] * Math.sin(angle);
        points.append(String.format(Locale.ROOT, "%.5f %.5f %.5f, ", x, profile[2 * ring + 1], z));
        if (ring > 0) {
          int a = (ring - 1) * sides + side;
          int b = (ring - 1) * sides + (side + 1) % sides;
          indices.append("%d %d %d %d -1 ".formatted(b, a, a + sides, b + sides));
        }
      }
    }
    return shape(
        "<IndexedFaceSet creaseAngle='0.9' solid='%s' coordIndex='%s'><Coordinate point='%s'/>"
                .formatted(solid, indices, points)
            + "</IndexedFaceSet>");
  }

  /** With a wall of two sides. */
  private static String mug(int sides) {
    return turned(
        sides, true, 0.001, 0, 0.045, 0, 0.045, 0.1, 0.041, 0.1, 0.041, 0.006, 0.001, 0.006);
  }

  /** Of sheet metal, wider at the top. */
  private static String can(int sides) {
    return turned(sides, false, 0.001, 0, 0.12, 0, 0.14, 0.15, 0.16, 0.3);
  }

  private static String cushion(int sides) {
    int rings = sides / 2;
    double[] profile = new double[2 * rings + 2];
    for (int i = 0; i <= rings; i++) {
      double angle = Math.PI * i / rings;
      profile[2 * i] = 0.001 + 0.4 * Math.sin(angle);
      profile[2 * i + 1] = 0.2 - 0.2 * Math.cos(angle);
    }
    return turned(sides, true, profile);
  }

  private static String choice(double x, double y, double z, String coarse, String fine) {
    return "<Transform translation='%s %s %s'><Switch whichChoice='1'>".formatted(x, y, z)
        + coarse
        + fine
        + "</Switch></Transform>";
  }

  @Test
  void roundThingsOfFewPolygonsAreShadedAsThoseOfMany() throws Exception {
    String lamp =
        "<SpotLight location='1.2 3 2' direction='0 -1 0' cutOffAngle='1.5' intensity='4'/>"
            + "<PointLight location='3.5 1.5 1.5'/>";
    LightmappedScene lit =
        lit(
            room(0, 0, 0, 4, "diffuseColor='0.8 0.8 0.8'")
                + lamp
                + choice(1, 0.8, 1, mug(20), mug(60))
                + choice(2, 0.5, 1, can(20), can(60))
                + choice(2.5, 0.3, 2.5, cushion(20), cushion(48)));
    VersionRayRenderer pictures = new VersionRayRenderer(lit);
    Vector3d[] middles = {
      new Vector3d(1, 0.85, 1), new Vector3d(2, 0.65, 1), new Vector3d(2.5, 0.5, 2.5)
    };
    double[] away = {0.3, 0.9, 1.4};
    for (int i = 0; i < middles.length; i++) {
      for (double turn : new double[] {0.4, 2.5, 4.6}) {
        Vector3d eye =
            new Vector3d(Math.cos(turn), 0.6, Math.sin(turn)).mul(away[i]).add(middles[i]);
        VersionRayRenderer.Difference difference =
            pictures.compare(2 * i + 1, 2 * i + 2, eye, middles[i], 100);
        assertThat(difference.pixels()).isGreaterThan(1_000);
        assertThat(difference.mean()).isLessThan(1.0 / 255);
      }
    }
  }
}
