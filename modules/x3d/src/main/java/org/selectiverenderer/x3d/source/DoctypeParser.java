package org.selectiverenderer.x3d.source;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;

/** Parses the general entity declarations in a DOCTYPE's internal subset (XML 1.0, 2.8, 4.2). */
final class DoctypeParser {
  private final CharSequence text;
  private final int most;
  private final Map<String, EntityTable.Declared> found = new LinkedHashMap<>();
  private int at;

  /**
   * Creates a parser of a text.
   *
   * @param most the maximum number of declarations
   */
  DoctypeParser(CharSequence text, int most) {
    this.text = text;
    this.most = most;
  }

  /** Returns the offset after the DOCTYPE. */
  int end() {
    return at;
  }

  /** Returns the entities by name; the first declaration of each is binding (XML 1.0, 4.2). */
  Map<String, EntityTable.Declared> read() {
    at = 0;
    while (!starts("<!DOCTYPE")) {
      if (at < text.length() && text.charAt(at) <= ' ') {
        at++;
      } else if (starts("<?")) {
        behind("?>");
      } else if (starts("<!--")) {
        behind("-->");
      } else {
        return Map.of(); // the root, or nothing
      }
    }
    at += "<!DOCTYPE".length();
    while (at < text.length() && text.charAt(at) != '[') {
      if (text.charAt(at) == '>') {
        at++;
        return Map.of();
      }
      pass();
    }
    at++;
    subset();
    return found;
  }

  private void subset() {
    while (at < text.length() && text.charAt(at) != ']' && found.size() < most) {
      if (starts("<!--")) {
        behind("-->");
      } else if (starts("<?")) {
        behind("?>");
      } else if (starts("<!ENTITY")) {
        entity();
      } else {
        pass();
      }
    }
    while (at < text.length() && text.charAt(at) != '>') {
      at++;
    }
    at = Math.min(at + 1, text.length());
  }

  private void entity() {
    int start = at;
    at += "<!ENTITY".length();
    space();
    if (at < text.length() && text.charAt(at) == '%') {
      declarationEnd(); // a parameter entity, which only a DTD can use
      return;
    }
    int from = at;
    while (at < text.length() && text.charAt(at) > ' ' && text.charAt(at) != '>') {
      at++;
    }
    String name = text.subSequence(from, at).toString();
    space();
    boolean quoted = at < text.length() && (text.charAt(at) == '"' || text.charAt(at) == '\'');
    int valueFrom = at + 1;
    if (quoted) {
      pass();
    }
    Optional<String> value =
        quoted ? Optional.of(characters(valueFrom, Math.max(valueFrom, at - 1))) : Optional.empty();
    if (!name.isEmpty()) {
      found.putIfAbsent(name, new EntityTable.Declared(name, value, start));
    }
    declarationEnd();
  }

  /** Resolves character references, which are expanded in the declaration (XML 1.0, 4.4.5). */
  private String characters(int from, int to) {
    String raw = text.subSequence(from, Math.min(to, text.length())).toString();
    if (!raw.contains("&#")) {
      return raw;
    }
    StringBuilder value = new StringBuilder();
    for (int i = 0; i < raw.length(); i++) {
      String name = raw.startsWith("&#", i) ? EntityTable.name(raw, i, raw.length()) : "";
      if (name.isEmpty()) {
        value.append(raw.charAt(i));
      } else {
        value.append(AttributeValueNormalizer.read(raw, i, i + name.length() + 2));
        i += name.length() + 1;
      }
    }
    return value.toString();
  }

  private void declarationEnd() {
    while (at < text.length() && text.charAt(at) != '>') {
      pass();
    }
    at = Math.min(at + 1, text.length());
  }

  /** Skips a character, or a quoted string. */
  private void pass() {
    char c = text.charAt(at);
    at++;
    if (c == '"' || c == '\'') {
      while (at < text.length() && text.charAt(at) != c) {
        at++;
      }
      at = Math.min(at + 1, text.length());
    }
  }

  private void space() {
    while (at < text.length() && text.charAt(at) <= ' ') {
      at++;
    }
  }

  private void behind(String word) {
    while (at < text.length() && !starts(word)) {
      at++;
    }
    at = Math.min(at + word.length(), text.length());
  }

  private boolean starts(String word) {
    return starts(text, at, word);
  }

  /** Returns whether a word is at an offset of a text. */
  static boolean starts(CharSequence text, int at, String word) {
    for (int i = 0; i < word.length(); i++) {
      if (at + i >= text.length() || text.charAt(at + i) != word.charAt(i)) {
        return false;
      }
    }
    return true;
  }
}
