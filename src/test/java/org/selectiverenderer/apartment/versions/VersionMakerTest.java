package org.selectiverenderer.apartment.versions;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.modelling.Bounds;
import org.selectiverenderer.modelling.Boxes;
import org.selectiverenderer.modelling.Colour;
import org.selectiverenderer.modelling.Look;
import org.selectiverenderer.modelling.Model;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.Rounds;

class VersionMakerTest {
  private static final Look GREY = Look.matt(Colour.grey(0.5));

  private final VersionMaker maker = new VersionMaker();
  private final Model lamp =
      Model.of(
          "deskLamp",
          Part.of("foot", GREY, Boxes.bevelled(0.2, 0.05, 0.2, 0.01, 4)),
          Part.of("bulb", GREY, Rounds.sphere(0.1, 24, 32).move(0, 0.3, 0)));

  @Test
  void versionOneIsTheRecipeWithMissingPolygonsAdded() {
    ObjectFile file = maker.original(lamp, 2000);

    assertThat(file.name()).isEqualTo("deskLamp_v1.x3d");
    assertThat(file.polygons()).isEqualTo(2000);
    assertThat(file.text()).contains("Desk lamp, version 1: 2000 polygons, as modelled");
    assertThat(file.text().split(" -1", -1)).hasSize(2001);
  }

  @ParameterizedTest
  @ValueSource(ints = {400, 401, 133, 1999})
  void versionTwoHasItsCountExactlyEvenIfItIsOdd(int polygons) {
    ObjectFile reduced = maker.reduced(maker.original(lamp, 2000), polygons);

    assertThat(reduced.polygons()).isEqualTo(polygons);
    assertThat(reduced.text().split(" -1", -1)).hasSize(polygons + 1);
    Bounds before = lamp.bounds();
    Bounds after = reduced.model().bounds();
    assertThat(after.height()).isCloseTo(before.height(), within(0.02));
    assertThat(after.minY()).isCloseTo(0, within(0.005));
  }

  @Test
  void theSameModelGivesTheSameText() {
    assertThat(new VersionMaker().reduced(new VersionMaker().original(lamp, 2000), 300).text())
        .isEqualTo(maker.reduced(maker.original(lamp, 2000), 300).text());
  }

  @Test
  void namesBecomeWords() {
    assertThat(VersionMaker.words("trashCan")).isEqualTo("Trash can");
    assertThat(VersionMaker.words("sofa1Pillow")).isEqualTo("Sofa 1 pillow");
  }
}
