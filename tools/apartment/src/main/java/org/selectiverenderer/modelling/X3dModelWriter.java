package org.selectiverenderer.modelling;

import org.selectiverenderer.base.decimal.DecimalText;
import org.selectiverenderer.geometry.Bounds;
import org.selectiverenderer.x3d.write.FaceSetWriter;
import org.selectiverenderer.x3d.write.TupleLines;
import org.selectiverenderer.x3d.write.ValueText;
import org.selectiverenderer.x3d.write.X3dWriter;

/**
 * Writes a model as an X3D 3.3 file of the Interchange profile: a Shape per part with an
 * IndexedFaceSet of triangles. The same model gives the same bytes on every machine, in every
 * locale; lines end in LF.
 *
 * <p>Coordinates have five digits at most: the grid is a hundred-thousandth of the power of ten
 * above the model's largest coordinate, so that a model of 0.3 m is exact to a hundredth of a
 * millimetre.
 */
public final class X3dModelWriter {
  private static final int DIGITS = 5;
  private static final int LINE = 100;
  private static final String ANISOTROPY = "4";

  private final String generator;

  /**
   * @param generator the program that made the models, for the meta element of the files
   */
  public X3dModelWriter(String generator) {
    this.generator = generator;
  }

  /**
   * @param fileName the title in the file's head, {@code trashCan_v1.x3d}
   * @param description one sentence without markup
   */
  public String text(ParametricModel model, String fileName, String description) {
    int decimals = decimals(model.bounds());
    X3dWriter out = new X3dWriter(64 * model.polygons() + 1000);
    out.file("Interchange", "3.3").open("head");
    out.meta("title", fileName).meta("description", description);
    out.meta("generator", generator).meta("license", "MIT").close();
    out.open("Scene");
    String title = Character.toUpperCase(model.name().charAt(0)) + model.name().substring(1);
    for (Part part : model.parts()) {
      out.open("Shape").def(title + "_" + part.name());
      appearance(out, part.look());
      faces(out, part, decimals);
      out.close();
    }
    return out.finish();
  }

  private static void appearance(X3dWriter out, Look look) {
    Cladding cladding = look.cladding();
    if (cladding == null) {
      out.material(LookFields.fields(look));
      return;
    }
    out.open("Appearance").empty("Material", LookFields.fields(look));
    out.open("ImageTexture");
    if (!cladding.repeats()) {
      out.attribute("repeatS", "false").attribute("repeatT", "false");
    }
    out.attribute("url", ValueText.strings(cladding.file()));
    String boundary = cladding.repeats() ? "REPEAT" : "CLAMP_TO_EDGE";
    out.open("TextureProperties", "boundaryModeS", boundary, "boundaryModeT", boundary);
    out.attribute("generateMipMaps", "true").attribute("magnificationFilter", "AVG_PIXEL");
    if (cladding.slanted()) {
      out.attribute("anisotropicDegree", ANISOTROPY);
    }
    String smaller = cladding.slanted() ? "AVG_PIXEL_AVG_MIPMAP" : "AVG_PIXEL_NEAREST_MIPMAP";
    out.attribute("minificationFilter", smaller).close();
    out.close().close();
  }

  private static void faces(X3dWriter out, Part part, int decimals) {
    TupleLines points = TupleLines.wide(LINE);
    float[] positions = part.mesh().positions();
    double unit = DecimalText.unit(decimals);
    for (int i = 0; i < positions.length; i += 3) {
      StringBuilder text = points.next();
      for (int k = 0; k < 3; k++) {
        text.append(k == 0 ? "" : " ");
        double onGrid = Rounding.cell(positions[i + k], unit) / unit;
        DecimalText.appendRounded(text, onGrid, decimals);
      }
    }
    FaceSetWriter faces =
        new FaceSetWriter(out, Math.toRadians(part.creaseAngle()), !part.bothSides())
            .index("coordIndex", TupleLines.wide(LINE).triangles(part.mesh().triangles()));
    Cladding cladding = part.look().cladding();
    if (cladding == null) {
      faces.values("Coordinate", "point", points).close();
      return;
    }
    CladdingText cover = new CladdingText(cladding, part.mesh());
    faces
        .index("texCoordIndex", TupleLines.wide(LINE).triangles(cover.corners()))
        .values("Coordinate", "point", points)
        .values("TextureCoordinate", "point", cover.points(TupleLines.wide(LINE)))
        .close();
  }

  /** Returns the number of decimals with which the largest coordinate has five digits. */
  static int decimals(Bounds b) {
    double largest = 0;
    for (double value : new double[] {b.minX(), b.minY(), b.minZ(), b.maxX(), b.maxY(), b.maxZ()}) {
      largest = Math.max(largest, Math.abs(value));
    }
    int decimals = DIGITS;
    for (double limit = 1; largest >= limit && decimals > 0; limit *= 10) {
      decimals--;
    }
    for (double limit = 0.1; largest < limit && decimals < 9; limit /= 10) {
      decimals++;
    }
    return decimals;
  }
}
