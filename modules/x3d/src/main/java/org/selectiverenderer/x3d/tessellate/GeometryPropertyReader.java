package org.selectiverenderer.x3d.tessellate;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.catalogue.NodeView;

/** Reads a geometry's property nodes: colours, normals, tangents, texture coordinates. */
final class GeometryPropertyReader {
  private GeometryPropertyReader() {}

  /** Returns the values of {@code color} as r, g, b, a between 0 and 1; null if there are none. */
  static float @Nullable [] colors(TessellationContext job) {
    NodeView color = job.node().node("color");
    if (color == null) {
      return null;
    }
    switch (color.type().name()) {
      case "Color", "ColorRGBA" -> {}
      default -> {
        job.problem("has a " + color.type().name() + ", which is not supported; it is left out");
        return null;
      }
    }
    float[] given = color.floats("color");
    if (color.type().name().equals("ColorRGBA")) {
      return inUnit(given) ? given : clamp(given.clone());
    }
    float[] rgba = new float[given.length / 3 * 4];
    for (int i = 0, j = 0; i + 2 < given.length; i += 3, j += 4) {
      rgba[j] = given[i];
      rgba[j + 1] = given[i + 1];
      rgba[j + 2] = given[i + 2];
      rgba[j + 3] = 1;
    }
    return clamp(rgba);
  }

  private static boolean inUnit(float[] values) {
    for (float value : values) {
      if (!(value >= 0 && value <= 1)) {
        return false;
      }
    }
    return true;
  }

  /** Clamps values to 0 to 1, NaN to 0; the file reader has reported those out of range. */
  private static float[] clamp(float[] values) {
    for (int i = 0; i < values.length; i++) {
      values[i] = values[i] >= 0 ? Math.min(values[i], 1) : 0;
    }
    return values;
  }

  /**
   * Returns the vectors of {@code normal}, normalized; null if there are none. A vector without a
   * direction becomes zero.
   */
  static float @Nullable [] normals(TessellationContext job) {
    NodeView normal = job.node().node("normal");
    if (normal == null || !normal.type().name().equals("Normal")) {
      return null;
    }
    float[] given = normal.floats("vector");
    float[] unit = null;
    for (int i = 0; i + 2 < given.length; i += 3) {
      double x = given[i];
      double y = given[i + 1];
      double z = given[i + 2];
      double square = x * x + y * y + z * z;
      if (!(Math.abs(square - 1) < 1e-5)) {
        unit = unit == null ? given.clone() : unit;
        double scale = square > 1e-60 && square < 1e80 ? 1 / Math.sqrt(square) : 0;
        unit[i] = scale == 0 ? 0 : (float) (x * scale);
        unit[i + 1] = scale == 0 ? 0 : (float) (y * scale);
        unit[i + 2] = scale == 0 ? 0 : (float) (z * scale);
      }
    }
    return unit == null ? given : unit;
  }

  /**
   * Returns the vectors of {@code tangent} (draft of X3D 4.1), each x, y, z and handedness; null if
   * there are none or they cannot be used.
   */
  static float @Nullable [] tangents(TessellationContext job) {
    NodeView node = job.node();
    NodeView tangent = node.type().field("tangent").isEmpty() ? null : node.node("tangent");
    // tangents are useless without the normals to which they are perpendicular
    if (tangent == null
        || !tangent.type().name().equals("Tangent")
        || node.node("normal") == null) {
      return null;
    }
    float[] given = tangent.floats("vector");
    return given.length > 0
            && allFinite(given, job, "tangents", "they follow from texture coordinates")
        ? given
        : null;
  }

  /**
   * Returns the points of the first TextureCoordinate of {@code texCoord}; null if there is none,
   * so that default coordinates are used.
   */
  static float @Nullable [] texCoords(TessellationContext job) {
    for (TextureCoordinateSource source : TextureCoordinateSource.of(job.node())) {
      if (source.set() == 0) {
        float[] given = source.node().floats("point");
        return finite(given, job, "default texture coordinates are used") ? given : null;
      }
      if (source.unknown()) {
        job.problem(
            "has a %s that is not supported; default texture coordinates are used"
                .formatted(source.words()));
      }
    }
    return null;
  }

  /** Returns the points of the further nodes of {@code texCoord}, in their order. */
  static List<VertexAttribute> moreTexCoords(TessellationContext job) {
    List<VertexAttribute> more = new ArrayList<>();
    for (TextureCoordinateSource source : TextureCoordinateSource.of(job.node())) {
      if (source.set() > 0) {
        float[] given = source.node().floats("point");
        boolean usable = finite(given, job, "they are all 0");
        more.add(
            new VertexAttribute(
                usable ? given : new float[given.length], source.components(), null));
      }
    }
    return more;
  }

  private static boolean finite(float[] given, TessellationContext job, String otherwise) {
    return allFinite(given, job, "texture coordinates", otherwise);
  }

  private static boolean allFinite(
      float[] given, TessellationContext job, String what, String otherwise) {
    for (float value : given) {
      if (!(Math.abs(value) < Float.POSITIVE_INFINITY)) {
        job.problem("has " + what + " that are not finite; " + otherwise);
        return false;
      }
    }
    return true;
  }
}
