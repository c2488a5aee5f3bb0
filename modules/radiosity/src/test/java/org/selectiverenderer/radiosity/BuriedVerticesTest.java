package org.selectiverenderer.radiosity;

import static org.assertj.core.api.Assertions.assertThat;
import static org.selectiverenderer.radiosity.TestScenes.quad;
import static org.selectiverenderer.radiosity.TestScenes.room;

import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.radiosity.bake.VertexLitScene;
import org.selectiverenderer.radiosity.parallel.RadiosityProgress;
import org.selectiverenderer.radiosity.scene.RadiosityScene;
import org.selectiverenderer.radiosity.trace.Ray;

/** Vertices in walls and behind furniture must not carry their darkness to where it is seen. */
class BuriedVerticesTest {
  private static final String GREY = "diffuseColor='0.7 0.7 0.7'";
  private static final String LAMP = "<PointLight location='2 2 2'/>";

  private static final RadiositySettings SETTINGS =
      new RadiositySettings(
          20,
          95,
          OptionalDouble.empty(),
          OptionalDouble.of(0.7),
          true,
          true,
          true,
          16,
          1,
          0,
          300_000,
          LightStorageSettings.VERTICES);

  private static String divided(int polygons, String body) {
    return "<Group><MetadataSet containerField='metadata' name='radiosity'>"
        + "<MetadataInteger containerField='value' name='polygons' value='%d'/></MetadataSet>"
            .formatted(polygons)
        + body
        + "</Group>";
  }

  /** The darkest red of the first body's corners, by how far from (x, y) they are. */
  private static double darkest(String scene, double x, double y, double from, double to)
      throws Exception {
    RadiosityScene read = TestScenes.read(scene);
    VertexLitScene lit =
        new VertexLightBaker(SETTINGS, RadiosityProgress.NONE).light(read, solution -> {});
    float[] colours = lit.colours(0);
    float[] corners = lit.facets().corners();
    double darkest = 1;
    int found = 0;
    for (int i = 0; i < colours.length; i += 3) {
      double away = Math.max(Math.abs(corners[i] - x), Math.abs(corners[i + 1] - y));
      if (away >= from && away <= to) {
        darkest = Math.min(darkest, colours[i]);
        found++;
      }
    }
    assertThat(found).isPositive();
    return darkest;
  }

  @Test
  void aWallCloseBehindAPictureHasTheLightOfWhatIsBesideIt() throws Exception {
    String wall = divided(400, quad("0 0 0, 4 0 0, 4 4 0, 0 4 0", GREY));
    String picture =
        "<Transform translation='2 2 0.02'><Shape><Appearance><Material/></Appearance>"
            + "<Box size='1.6 1.6 0.02'/></Shape></Transform>";
    String scene = wall + room(0, 0, 0, 4, GREY).replace("0 1 2 3 -1 5", "5") + picture + LAMP;

    assertThat(darkest(scene, 2, 2, 0, 0.5)).isGreaterThan(0.6 * darkest(scene, 2, 2, 1, 1.5));
  }

  /** Under a table a floor is dark indeed: what is seen there counts. */
  @Test
  void aFloorUnderATableStaysDark() throws Exception {
    String floor = divided(400, quad("0 0 0, 4 0 0, 4 4 0, 0 4 0", GREY));
    String table =
        "<Transform translation='2 2 0.3'><Shape><Appearance><Material/></Appearance>"
            + "<Box size='1.6 1.6 0.02'/></Shape></Transform>";
    String scene = floor + room(0, 0, 0, 4, GREY).replace("0 1 2 3 -1 5", "5") + table + LAMP;

    assertThat(darkest(scene, 2, 2, 0, 0.5)).isLessThan(0.6 * darkest(scene, 2, 2, 1, 1.5));
  }

  /**
   * The ceiling reaches into a hollow wall whose far side touches the next room's wall: a ray from
   * inside must not take that for a room.
   */
  @Test
  void aCeilingThatReachesIntoAHollowWallIsNotDarkAtItsEdge() throws Exception {
    String ceiling = divided(200, quad("0 0 4, 0 4 4, 4.1 4 4, 4.1 0 4", GREY));
    String scene =
        ceiling
            + room(0, 0, 0, 4, GREY).replace("5 4 7 6 -1 ", "")
            + quad("4.1 0 0, 4.1 0 4.01, 4.1 4 4.01, 4.1 4 0", GREY)
            + quad("4.1 0 0, 4.1 4 0, 4.1 4 4.01, 4.1 0 4.01", GREY)
            + LAMP;

    assertThat(darkest(scene, 4.1, 2, 0, 0.2)).isGreaterThan(0.7 * darkest(scene, 4.1, 2, 0.4, 1));
  }

  @Test
  void ofTwoSolidsThatTouchARayLeavesTheOneBeforeItEntersTheOther() throws Exception {
    String leaving = quad("1 0 0, 1 1 0, 1 1 1, 1 0 1", GREY);
    String entered = quad("1 0 0, 1 0 1, 1 1 1, 1 1 0", GREY);
    for (String scene : new String[] {leaving + entered, entered + leaving}) {
      RadiosityScene read = TestScenes.read(scene + LAMP);
      Ray ray = new Ray();
      ray.from(new double[] {0, 0.4, 0.3}, new double[] {1, 0, 0});
      ray.length = Double.POSITIVE_INFINITY;

      read.visibility().nearest(ray, 0);

      assertThat(ray.triangle).isNotEqualTo(Ray.NOTHING);
      assertThat(ray.behind).isTrue();
    }
  }
}
