package org.selectiverenderer.geometry.font;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class FontFaceTest {
  private final FontLibrary library = new FontLibrary();

  private static double area(Glyph glyph) {
    double sum = 0;
    float[] p = glyph.points();
    for (int i = 0; i < glyph.indices().length; i += 3) {
      int a = 2 * glyph.indices()[i];
      int b = 2 * glyph.indices()[i + 1];
      int c = 2 * glyph.indices()[i + 2];
      sum += (p[b] - p[a]) * (p[c + 1] - p[a + 1]) - (p[b + 1] - p[a + 1]) * (p[c] - p[a]);
    }
    return sum / 2;
  }

  @Test
  void theOhHasAHole() {
    Glyph oh = library.font(FontFamily.SANS, FontStyle.PLAIN).glyph('O');
    // A ring: much less than the ellipse that it fills, 0.66 by 0.75 em.
    assertThat(area(oh)).isBetween(0.15, 0.25);
    // No triangle covers the middle.
    float[] p = oh.points();
    for (int i = 0; i < oh.indices().length; i += 3) {
      double x = 0;
      double y = 0;
      for (int k = 0; k < 3; k++) {
        x += p[2 * oh.indices()[i + k]] / 3;
        y += p[2 * oh.indices()[i + k] + 1] / 3;
      }
      assertThat(Math.hypot(x - 0.394, y - 0.364)).isGreaterThan(0.2);
    }
  }

  @ParameterizedTest
  @EnumSource
  void everyCharacterOfEveryFontIsFilledToTheAreaOfItsOutline(FontStyle style) throws IOException {
    for (FontFamily family : FontFamily.values()) {
      TrueTypeFile file = file(family, style);
      for (int glyph : IntStream.range(0, 0x10000).map(file::glyphOf).distinct().toArray()) {
        List<float[]> contours = GlyphOutlineReader.of(file, glyph);
        double outline = -contours.stream().mapToDouble(GlyphTriangulator::area).sum();
        double parts =
            contours.stream().mapToDouble(c -> Math.abs(GlyphTriangulator.area(c))).sum();
        // A few letters of one font go round the wrong way; those have no holes.
        double expected = outline < 0 ? parts : outline;
        double filled = area(GlyphTriangulator.fill(contours, 0, 1));
        assertThat(filled)
            .as(family + " glyph " + glyph)
            .isCloseTo(expected, within(1 + 1e-3 * expected));
      }
    }
  }

  @Test
  void theLanguagesOfEuropeAreThere() throws IOException {
    String sample =
        "Az 09 \u00e4\u00f6\u00fc\u00df \u0141\u017e \u03a9\u03b1 \u0416\u0451"
            + " \u20ac\u2192\u2013\u201c";
    for (FontFamily family : FontFamily.values()) {
      for (FontStyle style : FontStyle.values()) {
        TrueTypeFile file = file(family, style);
        assertThat(sample.codePoints().map(file::glyphOf)).doesNotContain(0);
      }
    }
  }

  @Test
  void compositeGlyphsHoldTheirParts() {
    FontFace font = library.font(FontFamily.SANS, FontStyle.PLAIN);
    assertThat(area(font.glyph('\u00c4'))).isGreaterThan(area(font.glyph('A')) * 1.05);
    assertThat(font.glyph('\u00c4').advance()).isEqualTo(font.glyph('A').advance());
  }

  @Test
  void glyphsAreMadeOnce() {
    FontFace font = library.font(FontFamily.SERIF, FontStyle.ITALIC);
    assertThat(font.glyph('g')).isSameAs(font.glyph('g'));
    assertThat(library.font(FontFamily.SERIF, FontStyle.ITALIC)).isSameAs(font);
    assertThat(font.ascent()).isCloseTo(0.93f, within(0.01f));
    assertThat(font.descent()).isCloseTo(0.24f, within(0.01f));
  }

  @Test
  void familiesAndStylesAreFoundByName() {
    assertThat(FontFamily.of("Helvetica", "SANS", "SERIF")).isEqualTo(FontFamily.SANS);
    assertThat(FontFamily.of()).isEqualTo(FontFamily.SERIF);
    assertThat(FontFamily.of("typewriter")).isEqualTo(FontFamily.SERIF);
    assertThat(FontStyle.of("")).contains(FontStyle.PLAIN);
    assertThat(FontStyle.of("BOLDITALIC")).contains(FontStyle.BOLDITALIC);
    assertThat(FontStyle.of("HEAVY")).isEmpty();
  }

  private static TrueTypeFile file(FontFamily family, FontStyle style) throws IOException {
    try (InputStream in = FontFace.class.getResourceAsStream(family.resource(style))) {
      return new TrueTypeFile(ByteBuffer.wrap(in.readAllBytes()));
    }
  }
}
