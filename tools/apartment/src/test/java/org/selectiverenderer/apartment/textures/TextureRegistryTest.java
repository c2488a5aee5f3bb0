package org.selectiverenderer.apartment.textures;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.IntToDoubleFunction;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.formats.image.Srgb;

/** What covers surfaces; of what is outside the windows the kept files, which take long to make. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class TextureRegistryTest {
  private static final List<String> SURFACES =
      List.of(
          TextureRegistry.PARQUET,
          TextureRegistry.TILES,
          TextureRegistry.WALL_TILES,
          TextureRegistry.PLASTER,
          TextureRegistry.VENEER,
          TextureRegistry.CARPET);

  private final Map<String, TextureImage> pictures = new TreeMap<>();

  @BeforeAll
  void make() {
    SURFACES.forEach(name -> pictures.put(name, TextureRegistry.all().get(name).get()));
  }

  private TextureImage picture(String name) {
    return pictures.get(name);
  }

  @Test
  void aPictureHasTheSameBytesEveryTime() {
    for (String name : SURFACES) {
      assertThat(TextureRegistry.all().get(name).get().png()).isEqualTo(picture(name).png());
    }
  }

  /** The difference across its edges is none that two neighbours within do not have as well. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        TextureRegistry.PARQUET,
        TextureRegistry.TILES,
        TextureRegistry.WALL_TILES,
        TextureRegistry.PLASTER,
        TextureRegistry.VENEER
      })
  void aTileGoesOnBeyondItsEdges(String name) {
    TextureImage tile = picture(name);

    goesOn(tile.width(), x -> columns(tile, x, (x + 1) % tile.width()));
    goesOn(tile.height(), y -> rows(tile, y, (y + 1) % tile.height()));
  }

  private static void goesOn(int count, IntToDoubleFunction toNext) {
    double most = 0;
    for (int i = 0; i + 1 < count; i++) {
      most = Math.max(most, toNext.applyAsDouble(i));
    }
    assertThat(toNext.applyAsDouble(count - 1)).isLessThanOrEqualTo(most);
  }

  private static double columns(TextureImage picture, int a, int b) {
    double sum = 0;
    for (int y = 0; y < picture.height(); y++) {
      sum += Math.abs(picture.sample(a, y, 1) - picture.sample(b, y, 1));
    }
    return sum / picture.height();
  }

  private static double rows(TextureImage picture, int a, int b) {
    double sum = 0;
    for (int x = 0; x < picture.width(); x++) {
      sum += Math.abs(picture.sample(x, a, 1) - picture.sample(x, b, 1));
    }
    return sum / picture.width();
  }

  /** As the plain colours that the surfaces are known by: boards of three tones, two tiles, oak. */
  @ParameterizedTest
  @CsvSource({
    TextureRegistry.PARQUET + ", 0.3009, 0.1312, 0.0457",
    TextureRegistry.TILES + ", 0.4456, 0.3408, 0.2665",
    TextureRegistry.WALL_TILES + ", 0.7874, 0.7578, 0.6938",
    TextureRegistry.VENEER + ", 0.2632, 0.1065, 0.0331",
    TextureRegistry.PLASTER + ", 0.9, 0.9, 0.9"
  })
  void aSurfaceThrowsBackAsMuchLightAsItsPlainColour(
      String name, double red, double green, double blue) {
    double[] mean = picture(name).meanLight();

    assertThat(mean[0]).isCloseTo(red, within(0.01 * red));
    assertThat(mean[1]).isCloseTo(green, within(0.01 * green));
    assertThat(mean[2]).isCloseTo(blue, within(0.01 * blue));
  }

  /** A plain teal carpet with a third of cream and some rust throws back a quarter of the light. */
  @Test
  void theCarpetIsNeitherDarkNorBright() {
    double[] mean = picture(TextureRegistry.CARPET).meanLight();

    assertThat(0.2126 * mean[0] + 0.7152 * mean[1] + 0.0722 * mean[2])
        .isCloseTo(0.252, within(0.025));
  }

  /** A material's own colour tints it (X3D 3.3, 17.2.2.3): of red, green and blue it has none. */
  @Test
  void plasterIsGrey() {
    assertThat(picture(TextureRegistry.PLASTER).samples().count()).isEqualTo(1);
  }

  @ParameterizedTest
  @CsvSource({
    "outsideNorth, outsideEast", "outsideEast, outsideSouth",
    "outsideSouth, outsideWest", "outsideWest, outsideNorth"
  })
  void sidesOfTheViewMeet(String left, String right) throws IOException {
    BufferedImage a = ImageIO.read(Path.of("inlineNodes/textures/" + left + ".png").toFile());
    BufferedImage b = ImageIO.read(Path.of("inlineNodes/textures/" + right + ".png").toFile());
    double across = 0;
    double within = 0;
    for (int y = 0; y < a.getHeight(); y++) {
      across += difference(a.getRGB(a.getWidth() - 1, y), b.getRGB(0, y));
      within += difference(a.getRGB(a.getWidth() - 2, y), a.getRGB(a.getWidth() - 1, y));
      within += difference(b.getRGB(0, y), b.getRGB(1, y));
    }
    // Two pixels beside each other, in sides at right angles, are seen as far apart as two within.
    assertThat(across).isLessThan(within);
  }

  private static double difference(int argb, int other) {
    double sum = 0;
    for (int shift = 0; shift < 32; shift += 8) {
      sum += Math.abs((argb >> shift & 0xff) - (other >> shift & 0xff));
    }
    return sum;
  }

  /** Above is sky and below is ground, which the Background has itself. */
  @ParameterizedTest
  @ValueSource(strings = {"outsideNorth", "outsideEast", "outsideSouth", "outsideWest"})
  void aSideOfTheViewEndsInNothingAboveAndBelow(String side) throws IOException {
    BufferedImage view = ImageIO.read(Path.of("inlineNodes/textures/" + side + ".png").toFile());
    for (int x = 0; x < view.getWidth(); x++) {
      assertThat(view.getRGB(x, 0) >>> 24).isLessThan(3);
      assertThat(view.getRGB(x, view.getHeight() - 1) >>> 24).isLessThan(3);
      assertThat(view.getRGB(x, view.getHeight() * 6 / 10) >>> 24).isEqualTo(255);
    }
  }

  @Test
  void whatADisplayIsToldAndItsLightGoBothWays() {
    for (int i = 0; i <= 255; i++) {
      assertThat(255 * Srgb.display(Srgb.light(i / 255.0))).isCloseTo(i, within(1e-4));
    }
  }
}
