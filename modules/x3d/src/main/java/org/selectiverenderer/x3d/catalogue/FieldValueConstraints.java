package org.selectiverenderer.x3d.catalogue;

import java.lang.reflect.Array;
import java.util.LinkedHashSet;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.field.FieldType;

/** The constraints of the standard on field values beyond their type: bounds and keywords. */
public final class FieldValueConstraints {
  /** Fields whose bounds are ignored: the standard's text does not require unit length. */
  private static final Set<String> ANY_LENGTH = Set.of("direction", "vector", "plane");

  /** Fields whose list of keywords browsers may extend. */
  private static final Set<String> OPEN =
      Set.of(
          "family",
          "forceOutput",
          "name",
          "intersectionType",
          "function",
          "mode",
          "source",
          "transitionType",
          "type",
          "geometryType",
          "phaseFunction",
          "sortOrder",
          "objectType",
          "language");

  /** Node types whose field {@code type} or {@code mode} may not be extended. */
  private static final Set<String> CLOSED =
      Set.of(
          "BiquadFilter",
          "PeriodicWave",
          "ProjectionVolumeStyle",
          "ShaderPart",
          "ShaderProgram",
          "TextureCoordinateGenerator");

  private static final String BOX_SIZE = "must be at least 0, or -1 -1 -1 for unknown";

  /**
   * A value out of bounds.
   *
   * @param value the first number out of bounds, or the whole size of a box
   * @param bound the violated bound, such as {@code must be more than 0}
   */
  public record Beyond(String value, String bound) {}

  private FieldValueConstraints() {}

  /** Returns whether the numbers of a field have bounds. */
  public static boolean bounded(FieldDefinition field) {
    boolean any = !field.min().isEmpty() || !field.max().isEmpty();
    return boxSize(field) || any && !ANY_LENGTH.contains(field.name());
  }

  /**
   * Returns the first number of a value that is out of the field's bounds.
   *
   * @param value a value of the field's type, as {@link org.selectiverenderer.x3d.field.FieldType}
   *     represents it
   */
  public static Optional<Beyond> beyond(FieldDefinition field, Object value) {
    if (boxSize(field)) {
      return value instanceof float[] size && !isBoxSize(size)
          ? Optional.of(new Beyond(size[0] + " " + size[1] + " " + size[2], BOX_SIZE))
          : Optional.empty();
    }
    Bound least = bounded(field) ? Bound.of(field.min()) : null;
    Bound most = bounded(field) ? Bound.of(field.max()) : null;
    int count = value.getClass().isArray() ? Array.getLength(value) : 1;
    for (int i = 0; i < count && (least != null || most != null); i++) {
      double number = number(value, i);
      boolean low = least != null && (number < least.value || least.open && number == least.value);
      boolean high = most != null && (number > most.value || most.open && number == most.value);
      if (low) {
        String bound = "must be " + (least.open ? "more than " : "at least ") + least.text;
        return Optional.of(new Beyond(text(value, i), bound));
      }
      if (high) {
        String bound = "must be " + (most.open ? "less than " : "at most ") + most.text;
        return Optional.of(new Beyond(text(value, i), bound));
      }
    }
    return Optional.empty();
  }

  /** Returns whether a field is the size of a box; an author's own may have its name only. */
  private static boolean boxSize(FieldDefinition field) {
    return field.name().equals("bboxSize") && field.type() == FieldType.SFVec3f;
  }

  /** Returns whether this is a box size, or -1 -1 -1 for unknown (X3D 4.0, 10.2.2). */
  private static boolean isBoxSize(float[] size) {
    return size[0] >= 0 && size[1] >= 0 && size[2] >= 0
        || size[0] == -1 && size[1] == -1 && size[2] == -1;
  }

  private record Bound(double value, boolean open, String text) {
    static @Nullable Bound of(String cell) {
      if (cell.isEmpty()) {
        return null;
      }
      boolean open = cell.startsWith(">") || cell.startsWith("<");
      String text = open ? cell.substring(1) : cell;
      // the catalogue rounds multiples of pi up, by more than the error of a float
      return new Bound(Double.parseDouble(text), open, text);
    }
  }

  private static double number(Object value, int index) {
    if (value instanceof float[] floats) {
      return floats[index];
    }
    return ((Number) (value.getClass().isArray() ? Array.get(value, index) : value)).doubleValue();
  }

  private static String text(Object value, int index) {
    return String.valueOf(value.getClass().isArray() ? Array.get(value, index) : value);
  }

  /**
   * Returns the keywords allowed in a string field; empty if any string is allowed. They are the
   * standard's, and {@code GEOMETRY} for shaders, as in X_ITE and Castle.
   */
  public static Set<String> words(FieldDefinition field) {
    Set<String> known = new LinkedHashSet<>();
    for (String value : field.values()) {
      for (String word : value.split("[\"\\s]+")) {
        if (!word.isEmpty()) {
          known.add(word);
        }
      }
    }
    if (known.contains("VERTEX") && known.contains("FRAGMENT")) {
      known.add("GEOMETRY");
    }
    return known;
  }

  /**
   * Returns whether a field may have other words than the known keywords, too.
   *
   * @param node the name of the node type
   */
  public static boolean open(String node, FieldDefinition field) {
    return OPEN.contains(field.name()) && !CLOSED.contains(node);
  }
}
