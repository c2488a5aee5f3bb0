package org.selectiverenderer.enricher.form;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import org.selectiverenderer.enricher.text.Texts;

/**
 * Parses, formats and completes a list of schemas as an author types it: names separated by commas.
 * A name that contains a comma or begins with a quotation mark is quoted, with its own quotation
 * marks doubled, as in CSV; any other quotation mark is part of the name.
 */
final class SchemaListFormat {
  private static final char MARK = '"';

  private SchemaListFormat() {}

  /**
   * A list with a completed name.
   *
   * @param caret the new caret position
   */
  record Completed(String text, int caret) {}

  static ParseResult<List<String>> parse(String text) {
    List<String> names = new ArrayList<>();
    for (int from = 0; from <= text.length(); ) {
      int to = end(text, from);
      String part = text.substring(from, to).strip();
      if (part.chars().anyMatch(Character::isISOControl)) {
        return new ParseResult.Wrong<>(Texts.of("form.oneline"));
      }
      Optional<String> wrong = wrong(part);
      if (wrong.isPresent()) {
        return new ParseResult.Wrong<>(wrong.get());
      }
      String name = plain(part).strip();
      if (!name.isEmpty() && !names.contains(name)) {
        names.add(name);
      }
      from = to + 1;
    }
    return new ParseResult.Valid<>(List.copyOf(names));
  }

  /**
   * Returns the end of the item that begins at an offset: a comma outside of quotation marks, or
   * the end of the text.
   */
  private static int end(String text, int from) {
    int first = from;
    while (first < text.length() && Character.isWhitespace(text.charAt(first))) {
      first++;
    }
    int behind = first < text.length() && text.charAt(first) == MARK ? closed(text, first) : first;
    int comma = text.indexOf(',', behind);
    return comma < 0 ? text.length() : comma;
  }

  /**
   * Returns the offset after the quotation that begins at an offset; the end of the text if it is
   * not closed.
   */
  private static int closed(String text, int from) {
    int close = text.indexOf(MARK, from + 1);
    while (close >= 0 && text.startsWith("\"", close + 1)) {
      close = text.indexOf(MARK, close + 2);
    }
    return close < 0 ? text.length() : close + 1;
  }

  private static Optional<String> wrong(String part) {
    if (!part.startsWith("\"")) {
      return Optional.empty();
    }
    int behind = closed(part, 0);
    if (behind < part.length()) {
      return Optional.of(Texts.of("form.comma"));
    }
    boolean open = part.chars().filter(c -> c == MARK).count() % 2 == 1;
    return open ? Optional.of(Texts.of("form.quotation")) : Optional.empty();
  }

  /** Returns an item without its quotation marks; the closing one may be missing. */
  private static String plain(String part) {
    if (!part.startsWith("\"")) {
      return part;
    }
    boolean open = part.chars().filter(c -> c == MARK).count() % 2 == 1;
    return part.substring(1, open ? part.length() : part.length() - 1).replace("\"\"", "\"");
  }

  static String format(List<String> names) {
    return names.stream().map(SchemaListFormat::quoted).collect(Collectors.joining(", "));
  }

  private static String quoted(String name) {
    boolean plain = name.indexOf(',') < 0 && !name.startsWith("\"");
    return plain ? name : MARK + name.replace("\"", "\"\"") + MARK;
  }

  /**
   * Returns the known schemas that complete the name at the caret: those that begin with it, then
   * those that contain it, without those that are in the list already.
   */
  static List<String> proposals(String text, int caret, List<String> known) {
    String begun =
        plain(text.substring(from(text, caret), caret).strip()).strip().toLowerCase(Locale.ROOT);
    String others = text.substring(0, from(text, caret)) + "," + text.substring(to(text, caret));
    List<String> listed =
        parse(others) instanceof ParseResult.Valid<List<String>> valid ? valid.value() : List.of();
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

  /** Replaces the name at the caret by a schema. */
  static Completed complete(String text, int caret, String schema) {
    int from = from(text, caret);
    String before = text.substring(0, from) + (from == 0 ? "" : " ") + quoted(schema);
    return new Completed(before + text.substring(to(text, caret)), before.length());
  }

  /** Returns the start of the item with the caret. */
  private static int from(String text, int caret) {
    int from = 0;
    for (int end = end(text, 0); end < caret; end = end(text, from)) {
      from = end + 1;
    }
    return from;
  }

  private static int to(String text, int caret) {
    return Math.max(caret, end(text, from(text, caret)));
  }
}
