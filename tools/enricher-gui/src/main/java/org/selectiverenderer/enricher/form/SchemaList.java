package org.selectiverenderer.enricher.form;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;

/**
 * Schemas as an author types them: names separated by commas. A name with a comma in it stands in
 * quotation marks.
 */
final class SchemaList {
  private SchemaList() {}

  /**
   * A list with one of its names completed.
   *
   * @param caret where the author goes on typing
   */
  record Completed(String text, int caret) {}

  static Input<List<String>> parse(String text) {
    List<String> names = new ArrayList<>();
    StringBuilder name = new StringBuilder();
    boolean quoted = false;
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      if (c == '"') {
        quoted = !quoted;
      } else if (c == ',' && !quoted) {
        add(name, names);
      } else if (Character.isISOControl(c)) {
        return new Input.Wrong<>("Names of schemas are on one line");
      } else {
        name.append(c);
      }
    }
    if (quoted) {
      return new Input.Wrong<>("A quotation mark is not closed");
    }
    add(name, names);
    return new Input.Valid<>(List.copyOf(names));
  }

  private static void add(StringBuilder name, List<String> names) {
    String stripped = name.toString().strip();
    if (!stripped.isEmpty() && !names.contains(stripped)) {
      names.add(stripped);
    }
    name.setLength(0);
  }

  static String format(List<String> names) {
    return names.stream().map(SchemaList::quoted).collect(Collectors.joining(", "));
  }

  private static String quoted(String name) {
    return name.indexOf(',') >= 0 ? '"' + name + '"' : name;
  }

  /**
   * The known schemas that the name at the caret may become: those that begin with it, then those
   * that have it within; not those that the list has elsewhere.
   */
  static List<String> proposals(String text, int caret, List<String> known) {
    String begun = text.substring(from(text, caret), caret).strip().toLowerCase(Locale.ROOT);
    String others = text.substring(0, from(text, caret)) + "," + text.substring(to(text, caret));
    List<String> listed =
        parse(others) instanceof Input.Valid<List<String>> valid ? valid.value() : List.of();
    List<String> first = new ArrayList<>();
    List<String> second = new ArrayList<>();
    for (String schema : known) {
      String lower = schema.toLowerCase(Locale.ROOT);
      if (!listed.contains(schema) && lower.contains(begun)) {
        (lower.startsWith(begun) ? first : second).add(schema);
      }
    }
    first.addAll(second);
    return first;
  }

  /** Puts a schema in the place of the name at the caret. */
  static Completed complete(String text, int caret, String schema) {
    int from = from(text, caret);
    String before = text.substring(0, from) + (from == 0 ? "" : " ") + quoted(schema);
    return new Completed(before + text.substring(to(text, caret)), before.length());
  }

  private static int from(String text, int caret) {
    return text.lastIndexOf(',', caret - 1) + 1;
  }

  private static int to(String text, int caret) {
    int comma = text.indexOf(',', caret);
    return comma < 0 ? text.length() : comma;
  }
}
