package org.selectiverenderer.apartment.versions;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.modelling.Boxes;
import org.selectiverenderer.modelling.Look;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.Rounds;

class RecipeVersionsTest {
  private static final Look GREY = Look.matt(ModelColour.grey(0.5));

  private final RecipeVersions maker = new RecipeVersions();
  private final ParametricModel lamp =
      ParametricModel.of(
          "deskLamp",
          Part.of("foot", GREY, Boxes.bevelled(0.2, 0.05, 0.2, 0.01, 4)),
          Part.of("bulb", GREY, Rounds.sphere(0.1, 24, 32).move(0, 0.3, 0)));

  @Test
  void versionOneIsTheRecipeWithMissingPolygonsAdded() {
    MadeObject made = maker.versions(lamp, 2000, 400);
    RecipeFile file = made.files().get(0);

    assertThat(made.model().polygons()).isEqualTo(2000);
    assertThat(file.name()).isEqualTo("deskLamp_v1.x3d");
    assertThat(file.polygons()).isEqualTo(2000);
    assertThat(file.text()).contains("Desk lamp, version 1: 2000 polygons, as modelled");
    assertThat(triangles(file)).isEqualTo(2000);
  }

  @ParameterizedTest
  @ValueSource(ints = {400, 401, 133, 1999})
  void versionTwoHasItsCountExactlyEvenIfItIsOdd(int polygons) {
    RecipeFile file = maker.versions(lamp, 2000, polygons).files().get(1);

    assertThat(file.name()).isEqualTo("deskLamp_v2.x3d");
    assertThat(file.polygons()).isEqualTo(polygons);
    assertThat(triangles(file)).isEqualTo(polygons);
  }

  @Test
  void anObjectOfOneVersionHasNoNumber() {
    MadeObject made = maker.single(lamp);

    assertThat(made.files()).extracting(RecipeFile::name).containsExactly("deskLamp.x3d");
    assertThat(triangles(made.files().get(0))).isEqualTo(lamp.polygons());
  }

  @Test
  void theSameModelGivesTheSameText() {
    assertThat(new RecipeVersions().versions(lamp, 2000, 300).files())
        .isEqualTo(maker.versions(lamp, 2000, 300).files());
  }

  private static int triangles(RecipeFile file) {
    int sum = 0;
    for (String shape : file.text().split("coordIndex='")) {
      sum += shape.split("'", 2)[0].split(" -1", -1).length - 1;
    }
    return sum;
  }

  @Test
  void namesBecomeWords() {
    assertThat(RecipeVersions.words("trashCan")).isEqualTo("Trash can");
    assertThat(RecipeVersions.words("sofa1Pillow")).isEqualTo("Sofa 1 pillow");
  }
}
