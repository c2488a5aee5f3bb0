package org.selectiverenderer.modelling;

/**
 * A model as the text of an X3D 3.3 file of the Interchange profile: a Shape per part with an
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

  private final String generator;

  /**
   * @param generator what made the models, for the files' heads
   */
  public X3dModelWriter(String generator) {
    this.generator = generator;
  }

  /**
   * @param fileName the title in the file's head, {@code trashCan_v1.x3d}
   * @param description one sentence without markup
   */
  public String text(Model model, String fileName, String description) {
    int decimals = decimals(model.bounds());
    StringBuilder text = new StringBuilder(64 * model.polygons() + 1000);
    text.append("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n")
        .append("<X3D profile='Interchange' version='3.3'>\n  <head>\n");
    meta(text, "title", fileName);
    meta(text, "description", description);
    meta(text, "generator", generator);
    meta(text, "license", "MIT");
    text.append("  </head>\n  <Scene>\n");
    for (Part part : model.parts()) {
      shape(text, model.name(), part, decimals);
    }
    return text.append("  </Scene>\n</X3D>\n").toString();
  }

  private static void meta(StringBuilder text, String name, String content) {
    String escaped = content.replace("&", "&amp;").replace("<", "&lt;").replace("'", "&apos;");
    text.append("    <meta name='").append(name).append("' content='");
    text.append(escaped).append("'/>\n");
  }

  private static void shape(StringBuilder text, String model, Part part, int decimals) {
    text.append("    <Shape DEF='").append(Character.toUpperCase(model.charAt(0)));
    text.append(model.substring(1)).append('_').append(part.name());
    text.append("'>\n      <Appearance>\n        ").append(MaterialText.of(part.look()));
    text.append("\n      </Appearance>\n      <IndexedFaceSet");
    double crease = Math.toRadians(part.creaseAngle());
    if (crease > 0) {
      text.append(" creaseAngle='").append(DecimalText.of(crease, 3)).append('\'');
    }
    if (part.bothSides()) {
      text.append(" solid='false'");
    }
    text.append("\n          coordIndex='");
    int line = text.length();
    int[] triangles = part.mesh().triangles();
    for (int i = 0; i < triangles.length; i += 3) {
      line = separate(text, i, line);
      text.append(triangles[i]).append(' ').append(triangles[i + 1]).append(' ');
      text.append(triangles[i + 2]).append(" -1");
    }
    text.append("'>\n        <Coordinate point='");
    line = text.length();
    float[] positions = part.mesh().positions();
    for (int i = 0; i < positions.length; i += 3) {
      line = separate(text, i, line);
      for (int k = 0; k < 3; k++) {
        text.append(k == 0 ? "" : " ").append(DecimalText.of(positions[i + k], decimals));
      }
    }
    text.append("'/>\n      </IndexedFaceSet>\n    </Shape>\n");
  }

  /** A blank, or a new line where the one at hand is long enough; returns where the line began. */
  private static int separate(StringBuilder text, int index, int line) {
    if (index == 0) {
      return line;
    }
    if (text.length() - line < LINE) {
      text.append(' ');
      return line;
    }
    text.append('\n');
    return text.length();
  }

  /** So many decimals that the largest coordinate has five digits. */
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
