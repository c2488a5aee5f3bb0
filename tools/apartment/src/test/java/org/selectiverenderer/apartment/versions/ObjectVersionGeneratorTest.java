package org.selectiverenderer.apartment.versions;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.modelling.BoxBuilder;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.RoundSolidBuilder;

class ObjectVersionGeneratorTest {
  private static final ModelMaterial GREY = ModelMaterial.matt(ModelColour.grey(0.5));

  private final ObjectVersionGenerator maker = new ObjectVersionGenerator();
  private final ParametricModel lamp =
      ParametricModel.of(
          "deskLamp",
          Part.of("foot", GREY, BoxBuilder.bevelled(0.2, 0.05, 0.2, 0.01, 4)),
          Part.of("bulb", GREY, RoundSolidBuilder.sphere(0.1, 24, 32).move(0, 0.3, 0)));

  @Test
  void versionOneIsTheRecipeWithMissingPolygonsAdded() {
    GeneratedObject made = maker.versions(lamp, 2000, 400);
    GeneratedFile file = made.files().get(0);

    assertThat(made.model().polygons()).isEqualTo(2000);
    assertThat(file.name()).isEqualTo("deskLamp_v1.x3d");
    assertThat(file.polygons()).isEqualTo(2000);
    assertThat(file.text()).contains("Desk lamp, version 1: 2000 polygons, as modelled");
    assertThat(triangles(file)).isEqualTo(2000);
  }

  @ParameterizedTest
  @ValueSource(ints = {400, 401, 133, 1999})
  void versionTwoHasItsCountExactlyEvenIfItIsOdd(int polygons) {
    GeneratedFile file = maker.versions(lamp, 2000, polygons).files().get(1);

    assertThat(file.name()).isEqualTo("deskLamp_v2.x3d");
    assertThat(file.polygons()).isEqualTo(polygons);
    assertThat(triangles(file)).isEqualTo(polygons);
  }

  @Test
  void anObjectOfOneVersionHasNoNumber() {
    GeneratedObject made = maker.single(lamp);

    assertThat(made.files()).extracting(GeneratedFile::name).containsExactly("deskLamp.x3d");
    assertThat(triangles(made.files().get(0))).isEqualTo(lamp.polygons());
  }

  @Test
  void theSameModelGivesTheSameText() {
    assertThat(new ObjectVersionGenerator().versions(lamp, 2000, 300).files())
        .isEqualTo(maker.versions(lamp, 2000, 300).files());
  }

  private static int triangles(GeneratedFile file) {
    int sum = 0;
    for (String shape : file.text().split("coordIndex='")) {
      sum += shape.split("'", 2)[0].split(" -1", -1).length - 1;
    }
    return sum;
  }

  @Test
  void namesBecomeWords() {
    assertThat(ObjectVersionGenerator.words("trashCan")).isEqualTo("Trash can");
    assertThat(ObjectVersionGenerator.words("sofa1Pillow")).isEqualTo("Sofa 1 pillow");
  }
}
