package org.selectiverenderer.radiosity.reference;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.radiosity.LightStorageSettings;
import org.selectiverenderer.radiosity.LightingFixtures;
import org.selectiverenderer.radiosity.RadiositySettings;
import org.selectiverenderer.radiosity.bake.LightingResult;
import org.selectiverenderer.radiosity.scene.RadiosityScene;

/** The Cornell box: its colours, its walls, and its light against paths. */
class CornellBoxTest {
  private static final Path EXAMPLE = Path.of("docs", "examples", "cornell-box.x3d");

  /** As by default but for a coarser mesh: 8 cm. */
  private static final RadiositySettings QUICK =
      new RadiositySettings(
          50,
          98,
          OptionalDouble.empty(),
          OptionalDouble.of(0.08),
          true,
          true,
          true,
          64,
          1,
          0,
          300_000,
          LightStorageSettings.VERTICES);

  @TempDir private Path folder;

  @Test
  void theExampleIsWhatTheMeasurementsGive() throws Exception {
    if (Boolean.getBoolean("examples.write")) {
      Files.writeString(EXAMPLE, CornellBox.x3d());
    }
    assertThat(Files.readString(EXAMPLE)).isEqualTo(CornellBox.x3d());
  }

  @Test
  void aSurfaceThatReflectsAllIsWhite() {
    for (double share : new Spectrum(1, 1).ofSurface()) {
      assertThat(share).isCloseTo(1, within(1e-9));
    }
  }

  /** Equal energy at all wavelengths has X = Y = Z = 1 in CIE 1931: 1.2048, 0.9483, 0.9088. */
  @Test
  void theEyesFunctionsAreThoseOfTheStandard() {
    double[] rgb = new Spectrum(1, 1).ofLight();
    assertThat(rgb[0]).isCloseTo(1.2048, within(0.02));
    assertThat(rgb[1]).isCloseTo(0.9483, within(0.02));
    assertThat(rgb[2]).isCloseTo(0.9088, within(0.02));
  }

  @Test
  void everySurfaceFacesTheInside() throws Exception {
    RadiosityScene scene = read().scene();
    double[] inside = {0.278, 0.27, 0.01};
    double[] blocks = {0.186, 0.08, 0.169, 0.368, 0.16, 0.351};
    for (int i = 0; i < scene.triangles().count(); i++) {
      double[] normal = new double[3];
      double[] middle = new double[3];
      scene.triangles().normal(i, normal);
      scene.triangles().point(i, 1 / 3.0, 1 / 3.0, middle);
      String name = String.valueOf(scene.body(i).shape().node().name());
      int block = name.equals("ShortBlock") ? 0 : name.equals("TallBlock") ? 3 : -1;
      double along = 0;
      for (int axis = 0; axis < 3; axis++) {
        double from = block < 0 ? middle[axis] : blocks[block + axis];
        double to = block < 0 ? inside[axis] : middle[axis];
        along += normal[axis] * (to - from);
      }
      assertThat(along).as(name).isPositive();
    }
  }

  @Test
  void itsLightIsThatOfPathsWhereverItIsStored() throws Exception {
    ReferenceScene box = read();
    RadiosityScene scene = box.scene();
    PrimaryHits hits = PrimaryHits.of(scene, box.view("Camera"), 16, 16, 2);
    ReferenceImage reference = new ReferenceImage(scene, hits, 1);
    for (int i = 0; i < 12; i++) {
      reference.pass();
    }
    LightStorageSettings textures =
        new LightStorageSettings(
            LightStorageSettings.Kind.TEXTURES, OptionalDouble.of(60), 1, false);
    for (LightingResult lit :
        List.of(
            LightingFixtures.atVertices(scene, QUICK),
            LightingFixtures.inTextures(scene, QUICK.with(textures)))) {
      double[] ours = LightingResultRenderer.reflected(scene, hits, Irradiance.of(lit));
      ImageErrorMetrics comparison = ImageErrorMetrics.of(hits, ours, reference);
      String told = lit.getClass().getSimpleName() + "\n" + comparison.text();
      assertThat(comparison.error()).as(told).isLessThan(0.02 + comparison.noise());
      assertThat(comparison.bias()).as(told).isBetween(-0.02, 0.02);
    }
  }

  private ReferenceScene read() throws Exception {
    return ReferenceScene.read(Files.writeString(folder.resolve("box.x3d"), CornellBox.x3d()));
  }
}
