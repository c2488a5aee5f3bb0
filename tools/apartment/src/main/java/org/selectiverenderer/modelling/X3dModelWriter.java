package org.selectiverenderer.modelling;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.joml.Vector3d;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.x3d.write.FieldValueFormatter;
import org.selectiverenderer.x3d.write.IndexedFaceSetWriter;
import org.selectiverenderer.x3d.write.TupleListBuilder;
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

  private static void appearance(X3dWriter out, ModelMaterial look) {
    TextureMapping cladding = look.cladding();
    if (cladding == null) {
      out.material(MaterialFields.fields(look));
      return;
    }
    out.open("Appearance").empty("Material", MaterialFields.fields(look));
    out.open("ImageTexture");
    if (!cladding.repeats()) {
      out.attribute("repeatS", "false").attribute("repeatT", "false");
    }
    out.attribute("url", FieldValueFormatter.strings(cladding.file()));
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
    TupleListBuilder points = TupleListBuilder.wide(LINE);
    float[] positions = part.mesh().positions();
    double unit = DecimalFormatter.unit(decimals);
    for (int i = 0; i < positions.length; i += 3) {
      StringBuilder text = points.next();
      for (int k = 0; k < 3; k++) {
        text.append(k == 0 ? "" : " ");
        double onGrid = GridSnapping.cell(positions[i + k], unit) / unit;
        DecimalFormatter.appendRounded(text, onGrid, decimals);
      }
    }
    IndexedFaceSetWriter faces =
        new IndexedFaceSetWriter(out, Math.toRadians(part.creaseAngle()), !part.bothSides())
            .index("coordIndex", TupleListBuilder.wide(LINE).triangles(part.mesh().triangles()));
    TextureMapping cladding = part.look().cladding();
    if (cladding == null) {
      faces.values("Coordinate", "point", points).close();
      return;
    }
    TextureCoordinateIndex cover = new TextureCoordinateIndex(cladding, part.mesh());
    faces
        .index("texCoordIndex", TupleListBuilder.wide(LINE).triangles(cover.corners()))
        .values("Coordinate", "point", points)
        .values("TextureCoordinate", "point", cover.points(TupleListBuilder.wide(LINE)))
        .close();
  }

  /** Returns the number of decimals with which the largest coordinate has five digits. */
  static int decimals(BoundingBox b) {
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

  /**
   * Indexed texture coordinates of a mesh as X3D writes them: each pair once, and for every corner
   * of a triangle the number of its pair. Corners at one point have different pairs where faces of
   * a box meet.
   */
  private static final class TextureCoordinateIndex {
    /**
     * Decimals of texture coordinates: a fifth of a millimetre where an image is two metres wide.
     */
    private static final int DECIMALS = 4;

    private final Map<String, Integer> pairs = new LinkedHashMap<>();
    private final int[] corners;

    TextureCoordinateIndex(TextureMapping cladding, TriangleMesh mesh) {
      int[] t = mesh.triangles();
      corners = new int[t.length];
      for (int i = 0; i < t.length; i += 3) {
        Vector3d a = mesh.point(t[i]);
        Vector3d along = mesh.point(t[i + 1]).sub(a);
        Vector3d normal = along.cross(mesh.point(t[i + 2]).sub(a));
        for (int k = i; k < i + 3; k++) {
          double[] st = cladding.laying().at(mesh.point(t[k]), normal);
          String pair =
              DecimalFormatter.rounded(st[0], DECIMALS)
                  + " "
                  + DecimalFormatter.rounded(st[1], DECIMALS);
          corners[k] = pairs.computeIfAbsent(pair, key -> pairs.size());
        }
      }
    }

    /** Returns the numbers of the pairs, three for each triangle. */
    int[] corners() {
      return corners;
    }

    /** Appends the pairs to {@code out} and returns it. */
    TupleListBuilder points(TupleListBuilder out) {
      pairs.keySet().forEach(pair -> out.next().append(pair));
      return out;
    }
  }

  /**
   * Converts a material to the fields of an X3D Material, with default values (X3D 3.3, 12.4.4)
   * left out.
   */
  private static final class MaterialFields {

    private MaterialFields() {}

    /** Returns field names and values in turn. */
    static String[] fields(ModelMaterial look) {
      List<String> fields = new ArrayList<>();
      field(fields, "diffuseColor", colour(look.diffuse()), "0.8 0.8 0.8");
      field(fields, "specularColor", colour(look.specular()), "0 0 0");
      field(fields, "shininess", DecimalFormatter.rounded(look.shininess(), 3), "0.2");
      field(fields, "transparency", DecimalFormatter.rounded(look.transparency(), 3), "0");
      field(fields, "emissiveColor", colour(look.emissive()), "0 0 0");
      return fields.toArray(String[]::new);
    }

    private static void field(List<String> fields, String name, String value, String standard) {
      if (!value.equals(standard)) {
        fields.addAll(List.of(name, value));
      }
    }

    private static String colour(ModelColour colour) {
      return DecimalFormatter.rounded(colour.red(), 3)
          + " "
          + DecimalFormatter.rounded(colour.green(), 3)
          + " "
          + DecimalFormatter.rounded(colour.blue(), 3);
    }
  }
}
