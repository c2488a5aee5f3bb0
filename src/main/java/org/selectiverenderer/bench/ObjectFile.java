package org.selectiverenderer.bench;

import java.util.Locale;

/** The text of one inlined object: an IndexedFaceSet with a normal per point. */
final class ObjectFile {

  private ObjectFile() {}

  /**
   * @param name DEF name of the Shape
   * @param number picks the colour
   */
  static String text(String name, int number, FormMesh mesh) {
    FixedPointText text =
        new FixedPointText(7 * mesh.triangles().length + 16 * mesh.points().length + 800);
    text.append("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n")
        .append("<X3D profile='Interchange' version='3.3'>\n  <Scene>\n    <Shape DEF='")
        .append(name)
        .append("'>\n      <Appearance>\n        <Material ")
        .append(colour(number))
        .append("/>\n      </Appearance>\n      <IndexedFaceSet coordIndex='");
    int[] triangles = mesh.triangles();
    for (int t = 0; t < triangles.length; t += 3) {
      text.append(triangles[t]).append(triangles[t + 1]).append(triangles[t + 2]).append("-1 ");
    }
    text.append("'>\n        <Coordinate point='");
    for (double value : mesh.points()) {
      text.append(value, 5);
    }
    text.append("'/>\n        <Normal vector='");
    for (double value : mesh.normals()) {
      text.append(value, 3);
    }
    return text.append("'/>\n      </IndexedFaceSet>\n    </Shape>\n  </Scene>\n</X3D>\n")
        .toString();
  }

  /** Colours a golden angle apart in hue, so that neighbours differ. */
  private static String colour(int number) {
    double hue = 2.39996 * number;
    return String.format(
        Locale.ROOT,
        "diffuseColor='%.2f %.2f %.2f' specularColor='0.3 0.3 0.3' shininess='0.3'",
        0.55 + 0.3 * Math.cos(hue),
        0.55 + 0.3 * Math.cos(hue - 2 * Math.PI / 3),
        0.55 + 0.3 * Math.cos(hue + 2 * Math.PI / 3));
  }
}
