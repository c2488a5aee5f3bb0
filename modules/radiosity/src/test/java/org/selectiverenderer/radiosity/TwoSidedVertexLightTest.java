package org.selectiverenderer.radiosity;

import static org.assertj.core.api.Assertions.assertThat;
import static org.selectiverenderer.radiosity.TestScenes.bins;
import static org.selectiverenderer.radiosity.TestScenes.room;

import java.util.OptionalDouble;
import java.util.function.DoublePredicate;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.radiosity.bake.VertexLitScene;
import org.selectiverenderer.radiosity.parallel.RadiosityProgress;

/** Whose light the vertices have of what is seen from both sides. */
class TwoSidedVertexLightTest {
  private static final String GREY = "diffuseColor='0.735 0.735 0.735'";
  private static final String ROOM = room(0, 0, 0, 4, GREY);
  private static final String LAMP = "<PointLight location='0.5 2 2'/>";

  private static final RadiositySettings SETTINGS =
      new RadiositySettings(
          40,
          99.9,
          OptionalDouble.empty(),
          OptionalDouble.of(0.7),
          true,
          true,
          true,
          64,
          1,
          0,
          300_000,
          LightStorageSettings.VERTICES);

  private static VertexLitScene light(String scene) throws Exception {
    return new VertexLightBaker(SETTINGS, RadiosityProgress.NONE)
        .light(TestScenes.read(scene), each -> {});
  }

  /** The mean light of the first body's facets whose corners all are such, lux of green. */
  private static double mean(VertexLitScene lit, DoublePredicate x, DoublePredicate y) {
    double sum = 0;
    int found = 0;
    float[] corners = lit.facets().corners();
    for (int facet = 0; facet < lit.facets().firstOfBody()[1]; facet++) {
      boolean such = true;
      for (int at = 9 * facet; at < 9 * facet + 9; at += 3) {
        such &= x.test(corners[at]) && y.test(corners[at + 1]);
      }
      for (int corner = 3 * facet; such && corner < 3 * facet + 3; corner++) {
        sum += lit.light().irradiance()[3 * lit.facets().vertexOf()[corner] + 1];
        found++;
      }
    }
    assertThat(found).isPositive();
    return sum / found;
  }

  /** The side away from the lamp is dark outside, though the lamp shines on it from inside. */
  @Test
  void aBinHasTheLightOfItsOutsideAllAround() throws Exception {
    for (String bin : bins(GREY)) {
      VertexLitScene lit = light(bin + ROOM + LAMP);
      double towards = mean(lit, x -> x < 1.8501, y -> true);
      double away = mean(lit, x -> x > 2.1499, y -> true);
      assertThat(away).as(bin).isPositive().isLessThan(0.6 * towards);
    }
  }

  /** Outside of a room that is a sheet there is nobody, and no light. */
  @Test
  void aRoomHasTheLightOfItsInside() throws Exception {
    VertexLitScene lit =
        light(ROOM.replace("<IndexedFaceSet", "<IndexedFaceSet solid='false'") + LAMP);
    assertThat(mean(lit, x -> x > 3.99, y -> true)).isPositive();
  }

  /**
   * A sign whose foot lies on a box: the sign is lit from the side that its foot turns to the box.
   * People see the foot from above.
   */
  @Test
  void whereTheLitSideIsBuriedTheOtherCounts() throws Exception {
    String box =
        "<Transform translation='2.5 0.25 2'><Shape><Appearance><Material/></Appearance>"
            + "<Box size='0.5 0.5 0.5'/></Shape></Transform>";
    String sign =
        ("<Shape><Appearance><Material %s/></Appearance>"
                + "<IndexedFaceSet solid='false' coordIndex='0 1 2 3 -1 0 3 5 4 -1'>"
                + "<Coordinate point='2.3 0.5 1.83 2.3 1.5 1.83 2.3 1.5 2.15 2.3 0.5 2.15 "
                + "2.4 0.5 1.83 2.4 0.5 2.15'/></IndexedFaceSet></Shape>")
            .formatted(GREY);
    for (RadiosityProgress progress :
        new RadiosityProgress[] {
          RadiosityProgress.NONE, new CancelAtStage(RadiosityProgress.Stage.GATHERING)
        }) {
      VertexLitScene lit =
          new VertexLightBaker(SETTINGS, progress)
              .light(TestScenes.read(sign + box + ROOM + LAMP), each -> {});
      double foot = mean(lit, x -> x > 2.2999, y -> y < 0.5001);
      assertThat(foot).isGreaterThan(0.1 * mean(lit, x -> x < 2.3001, y -> true));
    }
  }
}
