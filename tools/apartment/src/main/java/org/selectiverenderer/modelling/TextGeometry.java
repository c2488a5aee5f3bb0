package org.selectiverenderer.modelling;

import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.geometry.font.FontFamily;
import org.selectiverenderer.geometry.font.FontStyle;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.x3d.tessellate.TextMesher;

/** Builds flat letters from triangles for keys, labels and book spines. Caches the glyphs. */
public final class TextGeometry {
  private final TextMesher mesher = new TextMesher();
  private final FontFamily family;
  private final FontStyle style;

  public TextGeometry(FontFamily family, FontStyle style) {
    this.family = family;
    this.style = style;
  }

  /** Returns a builder of bold sans-serif letters. */
  public static TextGeometry bold() {
    return new TextGeometry(FontFamily.SANS, FontStyle.BOLD);
  }

  /**
   * Returns a line of flat letters that faces +z at z = 0, centred on x and y. Place it half a
   * millimetre in front of the surface that it is written on.
   *
   * @param size length of an em, metres; capitals are about 0.73 em high
   */
  public TriangleMesh flat(String line, double size) {
    Mesh mesh = mesher.mesh(line, family, style, (float) size);
    TriangleMesh letters = new TriangleMesh(mesh.positions(), mesh.indices());
    BoundingBox b = letters.bounds();
    return letters.move(-(b.minX() + b.maxX()) / 2, -(b.minY() + b.maxY()) / 2, 0);
  }
}
