package org.selectiverenderer.bench;

import java.util.Locale;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.x3d.write.FieldValueFormatter;
import org.selectiverenderer.x3d.write.X3dWriter;

/** Writes a Switch with metadata around an inlined object, as in the thesis (5.4). */
final class BenchSwitchWriter {

  private BenchSwitchWriter() {}

  /**
   * @param folder of the object's file
   * @param room the object is inconsistent in this room's area, consistent in the house
   */
  static void write(X3dWriter out, String folder, String name, double x, double z, int room) {
    open(out, name, x, z, 0, "Room" + room + "Schema");
    out.empty("Inline", "DEF", "Inline_" + name, "url", url(folder, name));
    out.open("Shape").material("diffuseColor", "0.6 0.6 0.6");
    out.empty("Box", "size", "0.5 0.8 0.5").close().close().close();
  }

  /**
   * Writes a Switch around two versions of an object, the lower one of which it shows at first.
   *
   * @param high folder of the file with all polygons
   * @param low folder of the file with few
   * @param schema activates the version with all polygons
   */
  static void versions(
      X3dWriter out, String high, String low, String name, double x, double z, String schema) {
    open(out, name, x, z, 1, schema);
    out.empty("Inline", "DEF", "Inline_" + name + "_v1", "url", url(high, name));
    out.empty("Inline", "DEF", "Inline_" + name + "_v2", "url", url(low, name));
    out.close().close();
  }

  private static void open(
      X3dWriter out, String name, double x, double z, int choice, String schema) {
    String place = DecimalFormatter.fixed(x, 2) + " 0.42 " + DecimalFormatter.fixed(z, 2);
    out.open("Transform", "translation", place);
    out.open("Switch", "DEF", "Switch_" + name, "whichChoice", Integer.toString(choice));
    String set = "MetadataSet_" + name;
    out.open("MetadataSet", "containerField", "metadata", "DEF", set);
    part(out, set + "_Part1", "inconsistent", "low", schema);
    part(out, set + "_Part2", "consistent", "high", "HouseSchema");
    out.close();
  }

  private static String url(String folder, String name) {
    return FieldValueFormatter.strings(folder + "/" + name.toLowerCase(Locale.ROOT) + ".x3d");
  }

  private static void part(X3dWriter out, String def, String type, String degree, String schema) {
    out.open("MetadataSet", "containerField", "value", "DEF", def);
    string(out, "consistencyType", type);
    string(out, "degreeOfConsistency", degree);
    string(out, "schemaBelonginess", schema);
    out.close();
  }

  /** Writes a MetadataString in a MetadataSet. */
  static void string(X3dWriter out, String name, String value) {
    out.open("MetadataString", "containerField", "value", "name", name);
    out.attribute("value", FieldValueFormatter.strings(value)).close();
  }
}
