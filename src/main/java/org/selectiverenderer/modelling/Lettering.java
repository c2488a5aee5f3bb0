package org.selectiverenderer.modelling;

import org.selectiverenderer.x3d.geometry.Mesh;
import org.selectiverenderer.x3d.geometry.TextMesher;
import org.selectiverenderer.x3d.geometry.text.FontFamily;
import org.selectiverenderer.x3d.geometry.text.FontStyle;

/** Letters as triangles: keys, labels, book backs. Keeps the glyphs it has made. */
public final class Lettering {
  private final TextMesher mesher = new TextMesher();
  private final FontFamily family;
  private final FontStyle style;

  public Lettering(FontFamily family, FontStyle style) {
    this.family = family;
    this.style = style;
  }

  /** Bold letters without serifs. */
  public static Lettering bold() {
    return new Lettering(FontFamily.SANS, FontStyle.BOLD);
  }

  /**
   * A line of flat letters that faces +z at z = 0, centred on x and y. Put it half a millimetre
   * before the surface that it is written on.
   *
   * @param size length of an em, metres; capitals are about 0.73 of it
   */
  public TriangleMesh flat(String line, double size) {
    Mesh mesh = mesher.mesh(line, family, style, (float) size);
    TriangleMesh letters = new TriangleMesh(mesh.positions(), mesh.indices());
    Bounds b = letters.bounds();
    return letters.move(-(b.minX() + b.maxX()) / 2, -(b.minY() + b.maxY()) / 2, 0);
  }

  /** Solid letters from z = 0 to z = depth, centred on x and y. */
  public TriangleMesh raised(String line, double size, double depth) {
    return Sheet.thicken(flat(line, size), 0, 0, depth);
  }
}
