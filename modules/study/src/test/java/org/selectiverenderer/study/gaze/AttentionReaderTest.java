package org.selectiverenderer.study.gaze;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.study.headlog.HeadLog;
import org.selectiverenderer.study.headlog.HeadLogMetadata;
import org.selectiverenderer.study.headlog.HeadSample;
import org.selectiverenderer.study.headlog.SceneMap;
import org.selectiverenderer.study.headlog.SceneMap.Area;
import org.selectiverenderer.study.headlog.SceneMap.Box;

/** Logs of a few frames, counted by hand. */
class AttentionReaderTest {
  /** A cup 4 before the head and a lamp 4 behind it, in one room; a bed in another. */
  private static final SceneMap MAP =
      new SceneMap(
          List.of(
              new Area(
                  "DeskProx",
                  List.of(
                      new double[] {5, -1},
                      new double[] {7, -1},
                      new double[] {7, 1},
                      new double[] {5, 1}))),
          List.of(
              new Box("Office", new double[] {-10, 0, -10, 10, 3, 10}),
              new Box("Bedroom", new double[] {-10, 0, -30, 10, 3, -10})),
          List.of(
              new Box("Cup", new double[] {-0.5, 1, -4.5, 0.5, 2, -3.5}),
              new Box("Lamp", new double[] {-0.5, 1, 3.5, 0.5, 2, 4.5}),
              new Box("Bed", new double[] {-0.5, 1, -20.5, 0.5, 2, -19.5})),
          List.of());

  private static final GazeArea OFFICE = new GazeArea("OfficeSchema", true);

  private final List<HeadSample> samples = new ArrayList<>();

  private static HeadLog log(SceneMap map, List<HeadSample> samples) {
    return new HeadLog(
        new HeadLogMetadata("", "office.x3d", "high", 0, "", "", 0.5, 0.4, 1, 10, false, map),
        samples);
  }

  /** Adds frames of a tenth of a second. */
  private void look(int frames, double x, double yaw, String object, List<String> schemas) {
    for (int i = 0; i < frames; i++) {
      samples.add(
          new HeadSample(
              samples.size() / 10.0,
              x,
              1.5,
              0,
              yaw,
              0,
              0,
              true,
              object,
              1,
              0,
              object.isEmpty() ? List.of() : List.of(object),
              schemas,
              100,
              HeadSample.Moment.UNTOLD,
              null));
    }
  }

  @Test
  void timeInViewDwellLooksAndTheFirstLookAreCounted() {
    List<String> office = List.of("OfficeSchema");
    look(10, 0, 0, "", office); // the cup is in view, nobody looks at it
    look(5, 0, 0, "Cup", office);
    look(1, 0, 0, "Lamp", office); // passed over
    look(4, 0, 180, "Lamp", office);
    look(20, 0, 0, "Cup", office);
    Map<String, ObjectAttention> seen = AttentionReader.of(log(MAP, samples)).get(OFFICE);

    ObjectAttention cup = seen.get("Cup");
    assertThat(cup.inView()).isCloseTo(3.6, within(1e-9));
    assertThat(cup.dwell()).isCloseTo(2.5, within(1e-9));
    assertThat(cup.looks()).isEqualTo(2);
    assertThat(cup.fixations()).isEqualTo(2);
    assertThat(cup.found()).isEqualTo(1);
    assertThat(cup.waited()).isCloseTo(1, within(1e-9));
    assertThat(cup.meanSolidAngle()).isCloseTo(1 / 16.0, within(1e-3));
    assertThat(seen.get("Lamp").dwell()).isCloseTo(0.5, within(1e-9));
    assertThat(seen).doesNotContainKey("Bed"); // behind a wall
  }

  @Test
  void whatIsNeverLookedAtWaitsToTheEnd() {
    look(30, 0, 0, "", List.of("OfficeSchema"));
    ObjectAttention cup = AttentionReader.of(log(MAP, samples)).get(OFFICE).get("Cup");
    assertThat(cup).isEqualTo(new ObjectAttention(cup.inView(), cup.solidAngle(), 3, 0, 0, 0, 0));
  }

  @Test
  void aCrossingOfLessThanAFixationIsNoLook() {
    look(10, 0, 0, "", List.of("OfficeSchema"));
    look(1, 0, 0, "Cup", List.of("OfficeSchema"));
    look(10, 0, 0, "", List.of("OfficeSchema"));
    assertThat(AttentionReader.of(log(MAP, samples)).get(OFFICE).get("Cup").looks()).isZero();
  }

  @Test
  void eachAreaCountsByItself() {
    look(10, 0, 0, "Cup", List.of("OfficeSchema"));
    look(20, 0, 0, "Cup", List.of("DeskSchema", "OfficeSchema"));
    Map<GazeArea, Map<String, ObjectAttention>> seen = AttentionReader.of(log(MAP, samples));
    assertThat(seen.get(OFFICE).get("Cup").dwell()).isCloseTo(3, within(1e-9));
    assertThat(seen.get(new GazeArea("DeskSchema", true)).get("Cup").dwell())
        .isCloseTo(2, within(1e-9));
  }

  @Test
  void withoutSchemasTheAreaIsTheSensorsElseTheRoomElseTheScene() {
    look(1, 6, 0, "Cup", List.of());
    look(1, 0, 0, "Cup", List.of());
    look(1, 20, 0, "Cup", List.of());
    assertThat(AttentionReader.of(log(MAP, samples)).keySet())
        .containsExactly(
            new GazeArea("DeskProx", false), new GazeArea("Office", false), GazeArea.SCENE);
  }

  @Test
  void aLogThatKnowsNoPlacesCountsTheTimeNearTheMiddleOfTheView() {
    look(10, 0, 0, "Cup", List.of("OfficeSchema"));
    look(10, 0, 0, "", List.of("OfficeSchema"));
    ObjectAttention cup = AttentionReader.of(log(SceneMap.EMPTY, samples)).get(OFFICE).get("Cup");
    assertThat(cup.inView()).isCloseTo(1, within(1e-9));
    assertThat(cup.meanSolidAngle()).isEqualTo(1);
  }

  @Test
  void theSolidAngleFallsWithTheSquareOfTheDistance() {
    double[] cube = {-0.5, -0.5, -0.5, 0.5, 0.5, 0.5};
    assertThat(ViewingGeometry.solidAngle(cube, 0, 0, 100)).isCloseTo(1e-4, within(1e-7));
    assertThat(ViewingGeometry.solidAngle(cube, 0, 0, 200)).isCloseTo(2.5e-5, within(1e-8));
    // From a corner's direction it shows three faces, each under an angle of 54.7 degrees.
    double corner = 100 / Math.sqrt(3);
    assertThat(ViewingGeometry.solidAngle(cube, corner, corner, corner))
        .isCloseTo(Math.sqrt(3) * 1e-4, within(1e-7));
    assertThat(ViewingGeometry.solidAngle(cube, 0, 0, 0)).isEqualTo(2 * Math.PI);
  }
}
