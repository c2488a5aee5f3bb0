package org.selectiverenderer.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.selectiverenderer.render.context.Screenshot;
import org.selectiverenderer.testing.RequiresDisplay;

/** A shape is shaded as the metadata of its Appearance say, whatever the renderer is set to. */
@RequiresDisplay
class SurfaceShadingTest {
  /** Half way between a face's normal and the ridge's, (0, 0, 1), towards which the light is. */
  private static final int AT_PIXELS = 236;

  /** The mean of the light at the edge, cos 45 degrees, and at the ridge. */
  private static final int AT_VERTICES = 218;

  /** The cosine of 45 degrees. */
  private static final int OF_FACE = 180;

  /** A ridge of two faces, 45 degrees to each side, with a smooth normal between them. */
  private static String ridge(String metadata, String more) {
    return "<NavigationInfo headlight='false'/><DirectionalLight direction='0 0 -1'/>"
        + "<Shape><Appearance><Material diffuseColor='1 1 1' ambientIntensity='0'/>%s%s</Appearance>"
            .formatted(metadata, more)
        + "<IndexedFaceSet coordIndex='0 1 4 5 -1 1 2 3 4 -1' creaseAngle='3.1' solid='false'>"
        + "<Coordinate point='-4 -3 0 0 -3 4 4 -3 0 4 3 0 0 3 4 -4 3 0'/>"
        + "</IndexedFaceSet></Shape>";
  }

  private static String shading(String word) {
    return "<MetadataString DEF='S' name='shading' value='\"%s\"'/>".formatted(word);
  }

  private static int left(TestImageRenderer eye, TestScene scene) {
    return eye.shoot(scene).rgb(16, 32) & 255;
  }

  @ParameterizedTest
  @EnumSource(value = ShadingMode.class, names = "AUTO", mode = EnumSource.Mode.EXCLUDE)
  void eachLevelIsComputedWhereItSays(ShadingMode mode) {
    try (TestImageRenderer eye = new TestImageRenderer(mode)) {
      TestScene scene = TestScene.of(ridge(shading("pixel"), ""));
      assertThat(left(eye, scene)).isCloseTo(AT_PIXELS, within(2));
      scene.set("S", "value", new String[] {"vertex"});
      assertThat(left(eye, scene)).isCloseTo(AT_VERTICES, within(2));
      scene.set("S", "value", new String[] {"flat"});
      Screenshot flat = eye.shoot(scene);
      for (int x : new int[] {2, 16, 30, 34, 60}) {
        assertThat(flat.rgb(x, 32) & 255).as("at " + x).isCloseTo(OF_FACE, within(1));
      }
      scene.set("S", "value", new String[] {"wonderful"});
      assertThat(left(eye, scene)).as("as the renderer is set").isCloseTo(AT_PIXELS, within(3));
    }
  }

  @ParameterizedTest
  @EnumSource(value = ShadingMode.class, names = "AUTO", mode = EnumSource.Mode.EXCLUDE)
  void metadataInASetCountToo(ShadingMode mode) {
    String set =
        "<MetadataSet containerField='metadata'>"
            + "<MetadataString name='author' value='\"flat\"' containerField='value'/>"
            + shading("flat").replace("/>", " containerField='value'/>")
            + "</MetadataSet>";
    try (TestImageRenderer eye = new TestImageRenderer(mode)) {
      assertThat(left(eye, TestScene.of(ridge(set, "")))).isCloseTo(OF_FACE, within(1));
    }
  }

  @ParameterizedTest
  @EnumSource(value = ShadingMode.class, names = "AUTO", mode = EnumSource.Mode.EXCLUDE)
  void surfacesWithSeveralTexturesHaveFacesToo(ShadingMode mode) {
    String physical =
        ridge(shading("flat"), "")
            .replace(
                "<Material diffuseColor='1 1 1' ambientIntensity='0'/>",
                "<PhysicalMaterial baseColor='1 1 1' metallic='0' roughness='1'/>");
    try (TestImageRenderer eye = new TestImageRenderer(mode)) {
      TestScene scene = TestScene.of(physical);
      Screenshot flat = eye.shoot(scene);
      int edge = flat.rgb(2, 32) & 255;
      assertThat(flat.rgb(30, 32) & 255).isCloseTo(edge, within(6));
      scene.set("S", "value", new String[] {"pixel"});
      Screenshot smooth = eye.shoot(scene);
      assertThat(smooth.rgb(30, 32) & 255).isGreaterThan((smooth.rgb(2, 32) & 255) + 10);
    }
  }
}
