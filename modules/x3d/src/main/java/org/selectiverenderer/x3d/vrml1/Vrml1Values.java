package org.selectiverenderer.x3d.vrml1;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.x3d.field.FieldParser;
import org.selectiverenderer.x3d.field.FieldTokenizer;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.ElementTreeBuilder;
import org.selectiverenderer.x3d.vrml.VrmlScanner;
import org.selectiverenderer.x3d.vrml1.Vrml1Node.Field;
import org.selectiverenderer.x3d.vrml1.Vrml1Node.Field.Form;

/** Reads values of fields, where their text is not enough. */
final class Vrml1Values {
  /** More characters than a rotation or a matrix has, with the comments that people write. */
  private static final int BRIEF = 2000;

  private final ElementTreeBuilder document;
  private final FieldParser parser = new FieldParser();
  private final Map<Field, Integer> counts = new HashMap<>();
  private final Set<Field> seen = new HashSet<>();
  private long readAgain;
  private long copied;

  Vrml1Values(ElementTreeBuilder document) {
    this.document = document;
  }

  /** Returns the text of a field without comments. */
  String text(Field field) {
    if (!seen.add(field)) {
      readAgain += field.to() - field.from();
    }
    return document.value(field.from(), field.to());
  }

  /** Returns the text of a field of one value, of which only so much as it can need is copied. */
  String brief(Field field) {
    return document.value(field.from(), Math.min(field.to(), field.from() + BRIEF)).strip();
  }

  /** Returns how many characters were read that had been read before. */
  long readAgain() {
    return readAgain;
  }

  /** Counts characters that were written anew, though the file has them once. */
  void copied(long characters) {
    copied += characters;
  }

  /** Returns how many characters were written anew. */
  long copied() {
    return copied;
  }

  /** Returns how many numbers a field has; 0 if it is absent. */
  int count(@Nullable Vrml1Node node, String name) {
    Field field = node == null ? null : node.field(name);
    if (node == null || field == null) {
      return 0;
    }
    return counts.computeIfAbsent(field, known -> numbers(node, name).length);
  }

  /** Returns the numbers of a field as far as they are numbers; none if it is absent. */
  float[] numbers(Vrml1Node node, String name) {
    Field field = node.field(name);
    if (field == null || field.form() != Form.LIST && field.form() != Form.NUMBERS) {
      return new float[0];
    }
    Object value = parser.parse(FieldType.MFFloat, text(field)).value();
    return value instanceof float[] numbers ? numbers : new float[0];
  }

  /** Returns the numbers of a field; others if it has fewer than those or any is not finite. */
  float[] numbers(@Nullable Vrml1Node node, String name, float... others) {
    float[] found = node == null ? others : numbers(node, name);
    if (found.length < others.length) {
      return others;
    }
    for (float number : found) {
      if (!Float.isFinite(number)) {
        return others;
      }
    }
    return found;
  }

  /** Returns indices; null if there are none but the default, -1. */
  int @Nullable [] indices(Vrml1Node node, String name) {
    Field field = node.field(name);
    if (field == null || field.form() != Form.LIST && field.form() != Form.NUMBERS) {
      return null;
    }
    Object value = parser.parse(FieldType.MFInt32, text(field)).value();
    return value instanceof int[] found && found.length > 0 && !(found.length == 1 && found[0] < 0)
        ? found
        : null;
  }

  /** Returns the words of a field in upper case; empty if it is absent. */
  List<String> words(@Nullable Vrml1Node node, String name) {
    Field field = node == null ? null : node.field(name);
    List<String> words = new ArrayList<>();
    if (field != null && field.form() != Form.STRING) {
      for (String word : text(field).split("[\\s|,]+")) {
        if (!word.isEmpty()) {
          words.add(word.toUpperCase(Locale.ROOT));
        }
      }
    }
    return words;
  }

  /** Returns the only word of a field in upper case; empty if it is absent. */
  String word(@Nullable Vrml1Node node, String name) {
    List<String> words = words(node, name);
    return words.isEmpty() ? "" : words.get(0);
  }

  /** Returns the content of a string, whose quotes may be missing; empty if it is absent. */
  String string(Vrml1Node node, String name) {
    Field field = node.field(name);
    if (field == null) {
      return "";
    }
    String text = document.text().subSequence(field.from(), field.to()).toString();
    int open = text.indexOf('"');
    boolean quoted = open >= 0 && text.indexOf('"', open + 1) > open;
    return quoted
        ? VrmlScanner.unescaped(text.substring(open + 1, text.lastIndexOf('"')))
        : text.strip();
  }

  /** Returns strings as an MFString of X3D. */
  String strings(Field field) {
    String text = document.value(field.from(), field.to());
    return field.form() == Form.WORDS || field.form() == Form.NUMBERS
        ? FieldTokenizer.string(text.strip())
        : text.indexOf('\r') < 0 ? text : text.replaceAll("\r\n?", "\n");
  }

  /** Returns a number as text, with as many digits as a float has, and within its range. */
  static String number(double value) {
    double bounded = Math.max(-Float.MAX_VALUE, Math.min(Float.MAX_VALUE, value));
    return DecimalFormatter.shortest(Double.isNaN(bounded) ? 0 : (float) bounded);
  }

  /** Returns numbers as the text of one value. */
  static String tuple(double... values) {
    StringBuilder text = new StringBuilder();
    for (double value : values) {
      text.append(text.length() == 0 ? "" : " ").append(number(value));
    }
    return text.toString();
  }
}
