package org.selectiverenderer.x3d.write;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.field.FieldParser;
import org.selectiverenderer.x3d.field.FieldType;

/** Finds field types by name, or guesses them from the text of a value. */
final class FieldTypeResolver {
  private FieldTypeResolver() {}

  /** Returns the field type with a name; null if there is none. */
  static @Nullable FieldType of(String name) {
    for (FieldType type : FieldType.values()) {
      if (type.name().equals(name)) {
        return type;
      }
    }
    return null;
  }

  /** Returns a field type for which the text of a value of unknown type is valid. */
  static FieldType guess(String text) {
    FieldParser parser = new FieldParser();
    boolean strings = text.stripLeading().startsWith("\"");
    if (strings && parser.parse(FieldType.MFString, text).flaws().isEmpty()) {
      return FieldType.MFString;
    }
    boolean numbers = !text.isBlank() && parser.parse(FieldType.MFDouble, text).flaws().isEmpty();
    if (numbers) {
      boolean several = text.strip().matches("(?s).*[\\s,].*");
      return several ? FieldType.MFDouble : FieldType.SFDouble;
    }
    boolean flag = text.equals("true") || text.equals("false");
    return flag ? FieldType.SFBool : FieldType.SFString;
  }
}
