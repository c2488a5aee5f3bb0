package org.selectiverenderer.x3d.tessellate;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.selectiverenderer.geometry.font.FontFamily;
import org.selectiverenderer.geometry.font.FontStyle;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.x3d.catalogue.NodeView;

class TextTessellatorTest extends AbstractTessellatorTest {
  private final TextMesher mesher = new TextMesher();

  private Mesh text(NodeView fontStyle, String... lines) {
    return mesh("Text", "string", lines, "fontStyle", fontStyle);
  }

  private static NodeView style(Object... fields) {
    return node("FontStyle", fields);
  }

  private static String[] strings(String... strings) {
    return strings;
  }

  @Test
  void glyphsAreFlatAndFaceTheViewer() {
    Mesh mesh = mesh("Text", "string", strings("Hello"));
    assertThat(mesh.polygons()).isPositive();
    assertThat(mesh.solid()).isFalse();
    for (int i = 0; i < mesh.indices().length; i++) {
      assertThat(MeshProperties.point(mesh, i)[2]).isZero();
      assertThat(MeshProperties.normal(mesh, i)).containsExactly(0, 0, 1);
    }
    for (int i = 0; i < mesh.indices().length; i += 3) {
      assertThat(MeshProperties.cross(mesh, i)[2]).isNotNegative();
    }
  }

  @Test
  void defaultStartsAtTheOriginOnTheBaseLine() {
    Mesh mesh = mesh("Text", "string", strings("HH", "H"));
    assertThat(mesh.bounds()[0]).isBetween(0f, 0.2f);
    assertThat(mesh.bounds()[4]).isCloseTo(0.73f, within(0.02f));
    // The second line's base line is one em below the first.
    assertThat(mesh.bounds()[1]).isCloseTo(-1f, within(1e-6f));
  }

  @Test
  void sizeAndSpacingScaleLettersAndLines() {
    Mesh mesh = text(style("size", 2f, "spacing", 1.5f), "H", "H");
    assertThat(mesh.bounds()[4]).isCloseTo(2 * 0.73f, within(0.04f));
    assertThat(mesh.bounds()[1]).isCloseTo(-3f, within(1e-6f));
    Mesh up = text(style("topToBottom", false), "H", "H");
    assertThat(up.bounds()[1]).isCloseTo(0f, within(1e-6f));
    assertThat(up.bounds()[4]).isCloseTo(1.73f, within(0.02f));
  }

  @Test
  void majorJustifyPlacesTheLine() {
    float width = mesher.metrics("HHHH", FontFamily.SERIF, FontStyle.PLAIN, 1).width();
    Mesh begin = text(style(), "HHHH");
    float left = begin.bounds()[0];
    Mesh middle = text(style("justify", strings("MIDDLE")), "HHHH");
    Mesh end = text(style("justify", strings("END")), "HHHH");
    assertThat(middle.bounds()[0]).isCloseTo(left - width / 2, within(1e-5f));
    assertThat(end.bounds()[0]).isCloseTo(left - width, within(1e-5f));
    // Right to left, the beginning is the right edge.
    Mesh backwards = text(style("leftToRight", false), "HHHH");
    assertThat(backwards.bounds()[0]).isCloseTo(left - width, within(1e-5f));
    Mesh backwardsEnd = text(style("leftToRight", false, "justify", strings("END")), "HHHH");
    assertThat(backwardsEnd.bounds()[0]).isCloseTo(left, within(1e-5f));
  }

  @Test
  void minorJustifyPlacesTheBlock() {
    TextMesher.TextMetrics metrics = mesher.metrics("H", FontFamily.SERIF, FontStyle.PLAIN, 1);
    float base = text(style("justify", strings("BEGIN", "BEGIN")), "H", "H").bounds()[1];
    assertThat(base).isCloseTo(-metrics.ascent() - 1, within(1e-5f));
    float end = text(style("justify", strings("BEGIN", "END")), "H", "H").bounds()[1];
    assertThat(end).isCloseTo(metrics.descent(), within(1e-5f));
    float middle = text(style("justify", strings("BEGIN", "MIDDLE")), "H", "H").bounds()[1];
    assertThat(middle).isCloseTo((base + end) / 2, within(1e-5f));
    float upBegin =
        text(style("justify", strings("BEGIN", "BEGIN"), "topToBottom", false), "H", "H")
            .bounds()[1];
    assertThat(upBegin).isCloseTo(metrics.descent(), within(1e-5f));
  }

  @Test
  void verticalTextGoesDownAndItsColumnsRight() {
    Mesh down = text(style("horizontal", false), "HHH", "H");
    assertThat(down.bounds()[1]).isBetween(-3f, -2.5f);
    assertThat(down.bounds()[4]).isBetween(-0.5f, 0f);
    assertThat(down.bounds()[0]).isBetween(0f, 0.5f);
    assertThat(down.bounds()[3]).isBetween(1.5f, 2f);
    Mesh up = text(style("horizontal", false, "topToBottom", false), "HHH");
    assertThat(up.bounds()[4]).isBetween(2.5f, 3f);
    Mesh middle = text(style("horizontal", false, "justify", strings("MIDDLE", "MIDDLE")), "HHH");
    assertThat(middle.bounds()[0]).isCloseTo(-middle.bounds()[3], within(0.02f));
  }

  @Test
  void lengthStretchesItsLineOnly() {
    float width = mesher.metrics("HHHH", FontFamily.SERIF, FontStyle.PLAIN, 1).width();
    Mesh mesh = mesh("Text", "string", strings("HHHH", "H"), "length", new float[] {2 * width});
    Mesh natural = mesh("Text", "string", strings("HHHH"));
    assertThat(mesh.bounds()[3]).isCloseTo(2 * natural.bounds()[3], within(1e-5f));
    assertThat(mesh.bounds()[4]).isCloseTo(natural.bounds()[4], within(1e-5f));
  }

  @Test
  void maxExtentCompressesAllLinesByTheLongest() {
    Mesh natural = mesh("Text", "string", strings("HHHHHHHH", "H"));
    float width = mesher.metrics("HHHHHHHH", FontFamily.SERIF, FontStyle.PLAIN, 1).width();
    Mesh half = mesh("Text", "string", strings("HHHHHHHH", "H"), "maxExtent", width / 2);
    assertThat(half.bounds()[3]).isCloseTo(natural.bounds()[3] / 2, within(1e-5f));
    assertThat(half.bounds()[4]).isEqualTo(natural.bounds()[4]);
    Mesh wide = mesh("Text", "string", strings("H"), "maxExtent", 100f);
    assertThat(wide.bounds()[3]).isLessThan(1f);
  }

  @Test
  void textureStartsAtTheFirstLinesOriginAndIsOneEmLarge() {
    Mesh mesh = text(style("size", 2f, "justify", strings("MIDDLE")), "HHHH");
    float width = mesher.metrics("HHHH", FontFamily.SERIF, FontStyle.PLAIN, 2).width();
    for (int v = 0; v < mesh.vertexCount(); v++) {
      assertThat(mesh.texCoords()[2 * v])
          .isCloseTo((mesh.positions()[3 * v] + width / 2) / 2, within(1e-5f));
      assertThat(mesh.texCoords()[2 * v + 1])
          .isCloseTo(mesh.positions()[3 * v + 1] / 2, within(1e-5f));
    }
  }

  @Test
  void typewriterCharactersAreAllOfOneWidth() {
    for (FontStyle style : FontStyle.values()) {
      assertThat(mesher.metrics("iiii", FontFamily.TYPEWRITER, style, 1).width())
          .isEqualTo(mesher.metrics("WWWW", FontFamily.TYPEWRITER, style, 1).width());
    }
  }

  @Test
  void boldIsHeavierAndFamiliesDiffer() {
    for (FontFamily family : FontFamily.values()) {
      assertThat(MeshProperties.area(mesher.mesh("Hamburg", family, FontStyle.BOLD, 1)))
          .isGreaterThan(
              1.2 * MeshProperties.area(mesher.mesh("Hamburg", family, FontStyle.PLAIN, 1)));
    }
    assertThat(mesher.mesh("H", FontFamily.SANS, FontStyle.PLAIN, 1).polygons())
        .isLessThan(mesher.mesh("H", FontFamily.SERIF, FontStyle.PLAIN, 1).polygons());
  }

  @Test
  void fontStyleChoosesTheFont() {
    NodeView bold = style("family", strings("Arial", "SANS"), "style", "BOLD");
    assertThat(MeshProperties.area(text(bold, "Hamburg")))
        .isEqualTo(MeshProperties.area(mesher.mesh("Hamburg", FontFamily.SANS, FontStyle.BOLD, 1)));
  }

  @Test
  void missingCharactersShowAsBoxesAndControlCharactersAsSpaces() {
    Mesh box = mesh("Text", "string", strings("\u4e2d\ud83d\ude00"));
    assertThat(box.polygons()).isPositive();
    assertThat(mesh("Text", "string", strings("\t\n ")).isEmpty()).isTrue();
    assertThat(mesher.metrics("\t", FontFamily.SANS, FontStyle.PLAIN, 1).width())
        .isEqualTo(mesher.metrics(" ", FontFamily.SANS, FontStyle.PLAIN, 1).width());
  }

  @Test
  void emptyTextIsAnEmptyMesh() {
    assertThat(mesh("Text").isEmpty()).isTrue();
    assertThat(mesh("Text", "string", strings("")).isEmpty()).isTrue();
  }

  @Test
  void badFontStylesAreReportedAndReplaced() {
    Mesh mesh =
        mesh(
            node(
                "Text",
                "string",
                strings("H"),
                "fontStyle",
                style("size", -1f, "justify", strings("LEFT"))));
    assertThat(mesh.bounds()[4]).isCloseTo(0.73f, within(0.02f));
    assertThat(messages())
        .containsExactly(
            "Text has a FontStyle whose size is not above 0; 1 is used",
            "Text has a FontStyle with justify \"LEFT\"; BEGIN is used");
  }

  @Test
  void textBeyondTheBudgetOfTrianglesIsLeftOut() {
    Mesh mesh =
        tessellator
            .tessellate(
                node("Text", "string", strings("@".repeat(200_000), "@".repeat(200_000))), problems)
            .orElseThrow();
    assertThat(mesh.polygons())
        .isBetween(TextTessellator.MAX_TRIANGLES - 1000, TextTessellator.MAX_TRIANGLES);
    assertThat(problems.list())
        .singleElement()
        .asString()
        .contains("the remaining letters are left out");
  }
}
