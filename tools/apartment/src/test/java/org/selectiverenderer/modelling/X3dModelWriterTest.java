package org.selectiverenderer.modelling;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.geometry.mesh.TriangleMesh;

class X3dModelWriterTest {

  @Test
  void aModelIsOneShapePerPart() {
    TriangleMesh triangle =
        new TriangleMesh(new float[] {0, 0, 0, 0.25f, 0, -0.1f, 0, 1 / 3f, 0}, new int[] {0, 1, 2});
    ParametricModel model =
        ParametricModel.of(
            "flag",
            Part.of("cloth", ModelMaterial.matt(ModelColour.hex(0xFF8000)), triangle),
            Part.of(
                    "glow",
                    ModelMaterial.matt(ModelColour.grey(0.8)).glowing(ModelColour.of(1, 0, 0)),
                    triangle)
                .crease(0));
    Locale before = Locale.getDefault();
    try {
      Locale.setDefault(Locale.forLanguageTag("ar-EG"));

      assertThat(new X3dModelWriter("a test").text(model, "flag_v1.x3d", "A <flag>"))
          .isEqualTo(
              """
              <?xml version="1.0" encoding="UTF-8"?>
              <X3D profile='Interchange' version='3.3'>
                <head>
                  <meta name='title' content='flag_v1.x3d'/>
                  <meta name='description' content='A &lt;flag>'/>
                  <meta name='generator' content='a test'/>
                  <meta name='license' content='MIT'/>
                </head>
                <Scene>
                  <Shape DEF='Flag_cloth'>
                    <Appearance>
                      <Material diffuseColor='1 0.502 0' specularColor='0.02 0.02 0.02' shininess='0.1'/>
                    </Appearance>
                    <IndexedFaceSet creaseAngle='0.611' solid='false'
                        coordIndex='0 1 2 -1'>
                      <Coordinate point='0 0 0 0.25 0 -0.1 0 0.33333 0'/>
                    </IndexedFaceSet>
                  </Shape>
                  <Shape DEF='Flag_glow'>
                    <Appearance>
                      <Material specularColor='0.02 0.02 0.02' shininess='0.1' emissiveColor='1 0 0'/>
                    </Appearance>
                    <IndexedFaceSet solid='false'
                        coordIndex='0 1 2 -1'>
                      <Coordinate point='0 0 0 0.25 0 -0.1 0 0.33333 0'/>
                    </IndexedFaceSet>
                  </Shape>
                </Scene>
              </X3D>
              """);
    } finally {
      Locale.setDefault(before);
    }
  }

  @ParameterizedTest
  @CsvSource({"0.5, 5", "1.2, 4", "12, 3", "0.05, 6", "0.99999, 5"})
  void theLargestCoordinateHasFiveDigits(double largest, int decimals) {
    assertThat(X3dModelWriter.decimals(new BoundingBox(0, 0, 0, largest, 0.01, 0)))
        .isEqualTo(decimals);
  }

  @Test
  void linesOfNumbersAreBroken() {
    ParametricModel ball =
        ParametricModel.of(
            "ball",
            Part.of(
                "b", ModelMaterial.matt(ModelColour.grey(1)), RoundSolidBuilder.sphere(1, 9, 9)));

    assertThat(new X3dModelWriter("a test").text(ball, "b", "b").lines())
        .allSatisfy(line -> assertThat(line.length()).isLessThan(160));
  }
}
