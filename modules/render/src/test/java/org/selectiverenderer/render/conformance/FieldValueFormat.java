package org.selectiverenderer.render.conformance;

import java.lang.reflect.Array;
import java.util.Arrays;
import java.util.List;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.x3d.field.FieldParser;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.write.FieldValueFormatter;

/**
 * Parses and prints field values as the conformance scenes write them: nodes by their names, no
 * node as NULL.
 */
final class FieldValueFormat {
  private static final double TOLERANCE = 1e-4;
  private static final String NO_NODE = "NULL";

  private FieldValueFormat() {}

  /**
   * The value that a text means.
   *
   * @param nodes gives a node by its name
   */
  static @Nullable Object of(FieldType type, String text, Function<String, Node> nodes) {
    if (type == FieldType.SFNode) {
      return text.equals(NO_NODE) ? null : nodes.apply(text);
    }
    if (type == FieldType.MFNode) {
      return words(text).stream().map(nodes).toList();
    }
    FieldParser.Parsed parsed = new FieldParser().parse(type, text);
    if (parsed.value() == null || !parsed.flaws().isEmpty()) {
      throw new IllegalArgumentException(text + " is no " + type + ": " + parsed.flaws());
    }
    return parsed.value();
  }

  /** Returns whether a value equals the one that a text stands for; numbers within a tolerance. */
  static boolean agree(FieldType type, @Nullable Object value, String text) {
    if (type.isNode()) {
      return text(value).equals(String.join(" ", words(text)));
    }
    Object expected = of(type, text, name -> null);
    if (value == null || expected == null) {
      return value == expected;
    }
    if (value instanceof String[] strings) {
      return Arrays.equals(strings, (String[]) expected);
    }
    if (value.getClass().isArray()) {
      boolean same = Array.getLength(value) == Array.getLength(expected);
      for (int i = 0; same && i < Array.getLength(value); i++) {
        same = near(Array.get(value, i), Array.get(expected, i));
      }
      return same;
    }
    return near(value, expected);
  }

  private static boolean near(Object value, Object expected) {
    return value instanceof Number number && expected instanceof Number other
        ? Math.abs(number.doubleValue() - other.doubleValue()) <= TOLERANCE
        : value.equals(expected);
  }

  private static List<String> words(String text) {
    return text.isBlank() ? List.of() : List.of(text.strip().split("\\s+"));
  }

  /** Returns a value as scenes write it. */
  static String text(@Nullable Object value) {
    if (value == null) {
      return NO_NODE;
    }
    if (value instanceof Node node) {
      return node.name() == null ? node.type().name() : node.name();
    }
    if (value instanceof List<?> nodes) {
      return String.join(" ", nodes.stream().map(FieldValueFormat::text).toList());
    }
    return FieldValueFormatter.of(value);
  }
}
