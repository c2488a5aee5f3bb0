package org.selectiverenderer.x3d.tessellate;

import org.selectiverenderer.geometry.font.FontFace;
import org.selectiverenderer.geometry.font.FontFamily;
import org.selectiverenderer.geometry.font.FontStyle;
import org.selectiverenderer.geometry.font.Glyph;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.x3d.catalogue.NodeView;

/**
 * Tessellates Text nodes (X3D 4.0, 15.4.2). In vertical text each character is centred in a square
 * of one em. {@code length} and {@code maxExtent} stretch or compress the letters of a line.
 */
final class TextTessellator {
  /** The maximum number of triangles of a node, some hundred thousand letters. */
  static final int MAX_TRIANGLES = 5_000_000;

  private final TessellationContext job;
  private final FontFace font;
  private final TextLayout layout;
  private final TextMesher.Sheet sheet = new TextMesher.Sheet();
  private boolean full;

  private TextTessellator(TessellationContext job, FontFace font, TextLayout layout) {
    this.job = job;
    this.font = font;
    this.layout = layout;
  }

  static Mesh mesh(TessellationContext job, TextMesher mesher) {
    NodeView fontStyle = job.node().node("fontStyle");
    if (fontStyle != null && !TextLayout.known(fontStyle)) {
      job.problem(
          "has a " + fontStyle.type().name() + ", which is not supported; plain text is drawn");
      fontStyle = null;
    }
    FontFace font =
        fontStyle == null
            ? mesher.font(FontFamily.SERIF, FontStyle.PLAIN)
            : mesher.font(FontFamily.of(fontStyle.strings("family")), style(job, fontStyle));
    TextLayout layout = fontStyle == null ? TextLayout.DEFAULT : TextLayout.of(job, fontStyle);
    return new TextTessellator(job, font, layout).mesh();
  }

  private static FontStyle style(TessellationContext job, NodeView fontStyle) {
    String name = fontStyle.string("style");
    return FontStyle.of(name)
        .orElseGet(
            () -> {
              job.problem("has a FontStyle with style \"" + name + "\"; PLAIN is used");
              return FontStyle.PLAIN;
            });
  }

  private Mesh mesh() {
    String[] lines = job.node().strings("string");
    boolean solid = job.node().bool("solid");
    int[][] characters = new int[lines.length][];
    double[] lengths = new double[lines.length];
    double longest = 0;
    for (int i = 0; i < lines.length; i++) {
      characters[i] = lines[i].codePoints().toArray();
      lengths[i] = naturalLength(characters[i]);
      longest = Math.max(longest, wanted(i, lengths[i]));
    }
    float maxExtent = job.node().number("maxExtent");
    double compression = maxExtent > 0 && longest > maxExtent ? maxExtent / longest : 1;
    double block = blockBegin(lines.length);
    for (int i = 0; i < lines.length && !full; i++) {
      double length = wanted(i, lengths[i]) * compression;
      double stretch = lengths[i] > 0 ? length / lengths[i] : 1;
      double begin = TextLayout.begin(layout.major(), length);
      double across = block + i * layout.size() * layout.spacing();
      if (layout.horizontal()) {
        row(characters[i], begin, across, stretch);
      } else {
        column(characters[i], begin, across, stretch);
      }
    }
    if (full) {
      job.problem(
          "has more than %s triangles; the remaining letters are left out"
              .formatted(MAX_TRIANGLES));
    }
    Mesh mesh = sheet.mesh(solid, textureX(lengths, compression), textureY(), layout.size());
    for (float bound : mesh.bounds()) {
      if (!mesh.isEmpty() && !(Math.abs(bound) < Float.POSITIVE_INFINITY)) {
        job.problem("is too large; it is left out");
        return PrimitiveMeshBuilder.empty(solid);
      }
    }
    return mesh;
  }

  private double naturalLength(int[] characters) {
    if (!layout.horizontal()) {
      return characters.length * layout.size();
    }
    double length = 0;
    for (int character : characters) {
      length += font.glyph(character).advance();
    }
    return length * layout.size();
  }

  /** Returns the line's {@code length} in the node, or its natural length if unspecified. */
  private double wanted(int line, double natural) {
    float[] wanted = job.node().floats("length");
    boolean given = line < wanted.length && wanted[line] > 0 && wanted[line] < 1e30f;
    return given ? wanted[line] : natural;
  }

  /** Returns the position of the first line, measured in the direction in which lines advance. */
  private double blockBegin(int lines) {
    double advance = (lines - 1) * layout.size() * layout.spacing();
    TextLayout.Justify minor = layout.minor();
    if (!layout.horizontal()) {
      return TextLayout.begin(minor, advance + layout.size());
    }
    if (minor == TextLayout.Justify.FIRST) {
      return 0;
    }
    double ascent = font.ascent() * layout.size();
    double descent = font.descent() * layout.size();
    return TextLayout.begin(minor, advance + ascent + descent)
        + (layout.topToBottom() ? ascent : descent);
  }

  private void row(int[] characters, double begin, double across, double stretch) {
    double em = layout.size() * stretch;
    double y = layout.topToBottom() ? -across : across;
    double along = begin;
    for (int character : characters) {
      Glyph glyph = font.glyph(character);
      double advance = glyph.advance() * em;
      double x = layout.leftToRight() ? along : -along - advance;
      if (!fits(glyph)) {
        return;
      }
      sheet.add(glyph, x, y, em, layout.size());
      along += advance;
    }
  }

  private void column(int[] characters, double begin, double across, double stretch) {
    double size = layout.size();
    double cell = size * stretch;
    double left = layout.leftToRight() ? across : -across - size;
    double baseLine = font.descent() / (font.ascent() + font.descent());
    for (int i = 0; i < characters.length; i++) {
      Glyph glyph = font.glyph(characters[i]);
      double along = begin + i * cell;
      double bottom = layout.topToBottom() ? -along - cell : along;
      double x = left + (size - glyph.advance() * size) / 2;
      if (!fits(glyph)) {
        return;
      }
      sheet.add(glyph, x, bottom + baseLine * cell, size, cell);
    }
  }

  private boolean fits(Glyph glyph) {
    full |= sheet.triangleCount() + glyph.indices().length / 3 > MAX_TRIANGLES;
    return !full;
  }

  /** Returns the x of the origin of the first line. */
  private double textureX(double[] lengths, double compression) {
    if (!layout.horizontal()) {
      return layout.leftToRight() ? blockBegin(lengths.length) : -blockBegin(lengths.length);
    }
    if (lengths.length == 0) {
      return 0;
    }
    double length = wanted(0, lengths[0]) * compression;
    double begin = TextLayout.begin(layout.major(), length);
    return layout.leftToRight() ? begin : -begin - length;
  }

  /** Returns the y of the baseline of the first line. */
  private double textureY() {
    if (!layout.horizontal()) {
      return 0;
    }
    double begin = blockBegin(job.node().strings("string").length);
    return layout.topToBottom() ? -begin : begin;
  }
}
