package org.selectiverenderer.x3d.tessellate;

import java.util.Arrays;
import org.selectiverenderer.geometry.font.FontFace;
import org.selectiverenderer.geometry.font.FontFamily;
import org.selectiverenderer.geometry.font.FontLibrary;
import org.selectiverenderer.geometry.font.FontStyle;
import org.selectiverenderer.geometry.font.Glyph;
import org.selectiverenderer.geometry.mesh.Mesh;

/**
 * Tessellates single lines of text as flat triangles that face +z, for Text nodes and overlays.
 * Caches the glyphs. Thread-safe.
 */
public final class TextMesher {
  private final FontLibrary library = new FontLibrary();

  /**
   * Returns a line of text that starts at the origin and runs along +x, with its baseline at y = 0.
   * Characters missing in the font are shown as boxes, control characters as spaces.
   *
   * @param size the size of an em; capitals are about 0.73 of it high
   */
  public Mesh mesh(String line, FontFamily family, FontStyle style, float size) {
    FontFace font = font(family, style);
    Sheet sheet = new Sheet();
    double x = 0;
    for (int codePoint : line.codePoints().toArray()) {
      Glyph glyph = font.glyph(codePoint);
      sheet.add(glyph, x, 0, size, size);
      x += (double) glyph.advance() * size;
    }
    return sheet.mesh(false, 0, 0, size);
  }

  /** Returns the extent of the line that {@link #mesh} returns. */
  public TextMetrics metrics(String line, FontFamily family, FontStyle style, float size) {
    FontFace font = font(family, style);
    double width = 0;
    for (int codePoint : line.codePoints().toArray()) {
      width += font.glyph(codePoint).advance();
    }
    return new TextMetrics((float) (width * size), font.ascent() * size, font.descent() * size);
  }

  FontFace font(FontFamily family, FontStyle style) {
    return library.font(family, style);
  }

  /** Collects glyphs in the plane z = 0. */
  static final class Sheet {
    private float[] positions = new float[512];
    private int[] indices = new int[512];
    private int vertexCount;
    private int indexCount;

    int triangleCount() {
      return indexCount / 3;
    }

    /** Adds a glyph with its origin at x, y and an em of the given width and height. */
    void add(Glyph glyph, double x, double y, double emX, double emY) {
      float[] points = glyph.points();
      int needed = 3 * (vertexCount + points.length / 2);
      if (needed > positions.length) {
        positions = Arrays.copyOf(positions, Math.max(needed, 2 * positions.length));
      }
      if (indexCount + glyph.indices().length > indices.length) {
        indices =
            Arrays.copyOf(
                indices, Math.max(indexCount + glyph.indices().length, 2 * indices.length));
      }
      for (int index : glyph.indices()) {
        indices[indexCount++] = vertexCount + index;
      }
      for (int i = 0; i < points.length; i += 2) {
        positions[3 * vertexCount] = (float) (x + emX * points[i]);
        positions[3 * vertexCount + 1] = (float) (y + emY * points[i + 1]);
        vertexCount++;
      }
    }

    /**
     * Returns the mesh, with texture coordinates of origin x, y and scale 1 per em (X3D 4.0,
     * 15.2.1.2).
     *
     * @param solid whether back faces are culled
     */
    Mesh mesh(boolean solid, double x, double y, double em) {
      float[] xyz = Arrays.copyOf(positions, 3 * vertexCount);
      float[] normals = new float[xyz.length];
      float[] texCoords = new float[2 * vertexCount];
      for (int v = 0; v < vertexCount; v++) {
        normals[3 * v + 2] = 1;
        texCoords[2 * v] = (float) ((xyz[3 * v] - x) / em);
        texCoords[2 * v + 1] = (float) ((xyz[3 * v + 1] - y) / em);
      }
      int[] triangles = Arrays.copyOf(indices, indexCount);
      return new Mesh(
          Mesh.Primitive.TRIANGLES,
          xyz,
          normals,
          null,
          texCoords,
          triangles,
          solid,
          Mesh.boundsOf(xyz, triangles));
    }
  }

  /**
   * The extent of a line of text, in the unit of its size.
   *
   * @param width the advance width of the line
   * @param ascent the ascent above the baseline
   * @param descent the descent below the baseline, positive
   */
  public record TextMetrics(float width, float ascent, float descent) {}
}
