package org.selectiverenderer.authoring;

import java.util.List;
import org.selectiverenderer.x3d.field.FieldParser;
import org.selectiverenderer.x3d.field.FieldType;

/** Parses values of XML attributes. */
public final class MFStringParser {
  private MFStringParser() {}

  /** Returns the strings of an MFString, as tolerantly as the scene reader. */
  public static List<String> strings(String value) {
    int last = value.length() - 1;
    boolean one =
        last > 0
            && value.charAt(0) == '"'
            && value.indexOf('"', 1) == last
            && !value.contains("\\");
    if (one) {
      return List.of(value.substring(1, last)); // nearly all are: no parser is needed
    }
    Object parsed = new FieldParser().parse(FieldType.MFString, value).value();
    return parsed == null ? List.of() : List.of((String[]) parsed);
  }
}
