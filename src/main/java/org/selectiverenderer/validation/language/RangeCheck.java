package org.selectiverenderer.validation.language;

import java.lang.reflect.Array;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Problem.Severity;
import org.selectiverenderer.validation.FileCheck;
import org.selectiverenderer.validation.FileView;
import org.selectiverenderer.validation.Findings;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.DocumentAttribute;
import org.selectiverenderer.x3d.source.DocumentElement;

/** Values that are of their type, but beyond what the standard allows. */
final class RangeCheck implements FileCheck {
  /** Directions and planes need no unit length in the standard's text, though its model says so. */
  private static final Set<String> ANY_LENGTH = Set.of("direction", "vector", "plane");

  /** Lists of words that browsers may add to. */
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

  /** Types whose field {@code type} or {@code mode} is closed all the same. */
  private static final Set<String> CLOSED =
      Set.of("BiquadFilter", "PeriodicWave", "ProjectionVolumeStyle", "TextureCoordinateGenerator");

  private static final String BOX_SIZE = "must be at least 0, or -1 -1 -1 for unknown";

  @Override
  public void check(FileView file, Findings findings) {
    for (DocumentElement element : file.document().elements()) {
      file.catalogue()
          .find(element.name())
          .ifPresent(
              type -> {
                for (DocumentAttribute attribute : element.attributes()) {
                  type.field(attribute.name())
                      .filter(field -> field.access().initialisable())
                      .ifPresent(field -> check(attribute, field, findings));
                }
              });
    }
  }

  private static void check(DocumentAttribute attribute, FieldDefinition field, Findings findings) {
    boolean bounded = !field.min().isEmpty() || !field.max().isEmpty();
    if (field.name().equals("bboxSize")) {
      if (attribute.value(field.type()) instanceof float[] size && !isBoxSize(size)) {
        String shown = size[0] + " " + size[1] + " " + size[2];
        findings.add(FieldRules.RANGE, attribute, "bboxSize", shown, BOX_SIZE);
      }
    } else if (bounded && !ANY_LENGTH.contains(field.name())) {
      Object value = attribute.value(field.type());
      // What is no value of the type is SR103's; what stands for it is not the author's number.
      if (value != null && !flawed(attribute, field.type())) {
        range(attribute, field, value, findings);
      }
    } else if (!field.values().isEmpty() && field.type().kind() == FieldType.Kind.STRING) {
      words(attribute, field, findings);
    }
  }

  private static boolean flawed(DocumentAttribute attribute, FieldType type) {
    return attribute.flaws(type).stream().anyMatch(flaw -> flaw.severity() == Severity.ERROR);
  }

  /** Sides of a box, or the sign that they are to be computed (X3D 4.0, 10.2.2). */
  private static boolean isBoxSize(float[] size) {
    return size[0] >= 0 && size[1] >= 0 && size[2] >= 0
        || size[0] == -1 && size[1] == -1 && size[2] == -1;
  }

  private static void range(
      DocumentAttribute attribute, FieldDefinition field, Object value, Findings findings) {
    Bound least = Bound.of(field.min());
    Bound most = Bound.of(field.max());
    int count = value.getClass().isArray() ? Array.getLength(value) : 1;
    for (int i = 0; i < count; i++) {
      double number = number(value, i);
      boolean low = least != null && (number < least.value || least.open && number == least.value);
      boolean high = most != null && (number > most.value || most.open && number == most.value);
      if (low || high) {
        String bound =
            low
                ? "must be " + (least.open ? "more than " : "at least ") + least.text
                : "must be " + (most.open ? "less than " : "at most ") + most.text;
        findings.add(FieldRules.RANGE, attribute, field.name(), text(value, i), bound);
        return;
      }
    }
  }

  private record Bound(double value, boolean open, String text) {
    static @Nullable Bound of(String cell) {
      if (cell.isEmpty()) {
        return null;
      }
      boolean open = cell.startsWith(">") || cell.startsWith("<");
      String text = open ? cell.substring(1) : cell;
      // The catalogue rounds multiples of pi up; a float of them is larger by less than that.
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

  private static void words(DocumentAttribute attribute, FieldDefinition field, Findings findings) {
    Set<String> known = new LinkedHashSet<>();
    for (String value : field.values()) {
      for (String word : value.split("[\"\\s]+")) {
        known.add(word);
      }
    }
    Object value = attribute.value(field.type());
    List<String> given =
        value instanceof String[] strings
            ? List.of(strings)
            : value instanceof String string ? List.of(string) : List.of();
    boolean open = OPEN.contains(field.name()) && !CLOSED.contains(attribute.element().name());
    for (String word : given) {
      if (!known.contains(word) && !word.isEmpty()) {
        // In an open list only a slip of letter case is surely one.
        boolean slip = known.stream().anyMatch(word::equalsIgnoreCase);
        if (!open || slip) {
          findings.add(
              FieldRules.CHOICE, attribute, field.name(), word, Suggestion.of(word, known));
        }
      }
    }
  }
}
