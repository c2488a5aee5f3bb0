package org.selectiverenderer.x3d.write;

import java.util.List;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.x3d.field.FieldTokenizer;

/** Formats field values as X3D text (ISO/IEC 19776-1, 5), not yet escaped for XML. */
public final class FieldValueFormatter {
  private FieldValueFormatter() {}

  /**
   * Formats a value, with the shortest numbers that parse to the same values.
   *
   * @param value a value as {@link org.selectiverenderer.x3d.field.FieldType} represents it; not a
   *     node
   */
  public static String of(Object value) {
    StringBuilder text = new StringBuilder();
    if (value instanceof float[] numbers) {
      for (float number : numbers) {
        separate(text).append(DecimalFormatter.shortest(number));
      }
    } else if (value instanceof double[] numbers) {
      for (double number : numbers) {
        separate(text).append(DecimalFormatter.shortest(number));
      }
    } else if (value instanceof int[] numbers) {
      for (int number : numbers) {
        separate(text).append(number);
      }
    } else if (value instanceof boolean[] flags) {
      for (boolean flag : flags) {
        separate(text).append(flag);
      }
    } else if (value instanceof String[] strings) {
      for (String string : strings) {
        separate(text).append(FieldTokenizer.string(string));
      }
    } else if (value instanceof Float number) {
      text.append(DecimalFormatter.shortest(number));
    } else if (value instanceof Double number) {
      text.append(DecimalFormatter.shortest(number));
    } else {
      text.append(value);
    }
    return text.toString();
  }

  /** Formats strings as an MFString. */
  public static String strings(String... strings) {
    return of(strings);
  }

  /** Formats strings as an MFString. */
  public static String strings(List<String> strings) {
    return of(strings.toArray(String[]::new));
  }

  private static StringBuilder separate(StringBuilder text) {
    return text.length() == 0 ? text : text.append(' ');
  }
}
