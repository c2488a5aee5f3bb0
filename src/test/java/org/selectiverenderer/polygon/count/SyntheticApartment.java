package org.selectiverenderer.polygon.count;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * A synthetic apartment with the sensors and polygon counts of the thesis; its objects are zigzag
 * bands of exactly that many triangles.
 */
public final class SyntheticApartment {
  private static final Map<String, Integer> SINGLE_VERSION =
      Map.of("kitchen", 12744, "lounge", 5922, "office", 5184);

  private static final Map<String, String> MIDDLE =
      Map.of("kitchen", "-14 0 0", "lounge", "-5 0 0", "office", "5 0 0");

  private SyntheticApartment() {}

  /** Writes the scene and what it inlines; returns the scene. */
  public static Path write(Path folder) throws IOException {
    Files.createDirectories(folder.resolve("inlineNodes"));
    StringBuilder scene = new StringBuilder("<X3D profile='Immersive' version='3.3'><Scene>\n");
    for (String area : List.of("kitchen", "lounge", "office")) {
      room(folder, area, scene);
    }
    scene.append(
        area("boxLibrary", "1.078 2.368 1.338", "3.744 -1.93 -1.107", "0 0.8219 0")
            + sensor("BookcaseProx", "2.643 1.644 3.159", "BookcaseSchema", "OfficeSchema"));
    scene.append(
        area("boxDesk", "1.809 2.182 1.0", "5.779 -1.946 0.7717", "0 0.8541 0")
            + sensor("DeskProx", "3.255 1.708 3.449", "DeskSchema", "OfficeSchema"));
    scene.append(
        area("boxLounge", "1.14 1.058 1.136", "-5.461 -1.963 0.4947", "0 1.76 0")
            + sensor("SofaProx", "5.727 3.52 4.799", "SofaSchema", "LoungeSchema"));
    Path file = folder.resolve("apartment.x3d");
    Files.writeString(file, scene.append("</Scene></X3D>\n"));
    return file;
  }

  private static void room(Path folder, String area, StringBuilder scene) throws IOException {
    scene.append(
        "<Group DEF='%s'><Transform translation='%s'>\n".formatted(title(area), MIDDLE.get(area)));
    scene.append("<Shape><Box size='9 4 9'/></Shape>\n"); // of 12 triangles
    scene.append(band(SINGLE_VERSION.get(area) - 12));
    for (ThesisPolygonCounts.ThesisObject object : ThesisPolygonCounts.objects()) {
      if (object.area().equals(area)) {
        String title = title(object.object());
        inline(folder, object.object() + "_v1", object.v1());
        inline(folder, object.object() + "_v2", object.v2());
        scene.append(
            """
            <Transform DEF='Transform_%1$s'><Switch DEF='Switch_%1$s' whichChoice='1'>
            <MetadataSet containerField='metadata'>
            %2$s
            %3$s
            </MetadataSet>
            <Inline url='"inlineNodes/%4$s_v1.x3d"'/><Inline url='"inlineNodes/%4$s_v2.x3d"'/>
            </Switch></Transform>
            """
                .formatted(
                    title,
                    object.revolves().isEmpty()
                        ? "<MetadataSet containerField='value'/>"
                        : version("inconsistent", "low", title(object.revolves()) + "Schema"),
                    version("consistent", "high", title(area) + "Schema"),
                    object.object()));
      }
    }
    scene.append("</Transform></Group>\n");
  }

  private static String version(String type, String degree, String schema) {
    return """
        <MetadataSet containerField='value'>
        <MetadataString containerField='value' name='consistencyType' value='"%s"'/>
        <MetadataString containerField='value' name='degreeOfConsistency' value='"%s"'/>
        <MetadataString containerField='value' name='schemaBelonginess' value='"%s"'/>
        </MetadataSet>"""
        .formatted(type, degree, schema);
  }

  private static String area(String def, String scale, String translation, String inner) {
    return "<Transform DEF='%s' scale='%s' translation='%s'><Transform translation='%s'>"
        .formatted(def, scale, translation, inner);
  }

  private static String sensor(String def, String size, String enter, String exit) {
    return """
        <ProximitySensor DEF='%s' size='%s'><MetadataSet containerField='metadata'>
        <MetadataString containerField='value' name='enterTimeSchema' value='"%s"'/>
        <MetadataString containerField='value' name='exitTimeSchema' value='"%s"'/>
        </MetadataSet></ProximitySensor></Transform></Transform>
        """
        .formatted(def, size, enter, exit);
  }

  private static void inline(Path folder, String name, int triangles) throws IOException {
    Files.writeString(
        folder.resolve("inlineNodes").resolve(name + ".x3d"),
        "<X3D profile='Immersive' version='3.3'><Scene>" + band(triangles) + "</Scene></X3D>");
  }

  /** A strip of triangles, a metre long and wide. */
  static String band(int triangles) {
    StringBuilder points = new StringBuilder();
    for (int i = 0; i < triangles + 2; i++) {
      points.append(i % 2).append(" 0 ").append(i).append(' ');
    }
    return String.format(
        Locale.ROOT,
        "<Transform scale='1 1 %.9f'><Shape><TriangleStripSet stripCount='%d'><Coordinate"
            + " point='%s'/></TriangleStripSet></Shape></Transform>\n",
        1.0 / triangles,
        triangles + 2,
        points);
  }

  private static String title(String word) {
    return Character.toUpperCase(word.charAt(0)) + word.substring(1);
  }
}
