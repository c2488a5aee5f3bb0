package org.selectiverenderer.authoring.editing;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.Map;

/**
 * The XML context of a caret, determined from the characters before it, which need not be
 * well-formed.
 *
 * @param kind kind of the text that may be typed
 * @param from offset of the word at the caret
 * @param element the tag's name; for {@link Kind#CONTENT}, {@link Kind#NAME} and {@link Kind#END}
 *     that of the innermost open element, empty for none
 * @param attribute the attribute whose value contains the caret; else empty
 * @param quote the quote character around that value
 * @param given values of the tag's attributes before the caret
 */
record CaretContext(
    Kind kind, int from, String element, String attribute, char quote, Map<String, String> given) {
  /** The largest distance in characters at which tags are searched. */
  private static final int FAR = 2_000_000;

  /** The kind of text that may be typed. */
  enum Kind {
    /** Text or a tag. */
    CONTENT,
    /** The name of a tag, after its {@code <}. */
    NAME,
    /** The name of an end tag, after {@code </}. */
    END,
    /** An attribute. */
    ATTRIBUTE,
    /** An attribute's value. */
    VALUE,
    /** No proposals: in a comment, in a declaration, after a slash. */
    NOTHING
  }

  static CaretContext at(CharSequence text, int caret) {
    if (CommentToggle.openBefore(text, caret) >= 0) {
      return nothing(caret);
    }
    int open = lastOpen(text, caret);
    if (open < 0) {
      return content(text, caret);
    }
    if (starts(text, open, "<!") || starts(text, open, "<?")) {
      return closes(text, open, caret, ">") ? content(text, caret) : nothing(caret);
    }
    return inTag(text, open, caret);
  }

  private static int lastOpen(CharSequence text, int caret) {
    for (int i = caret - 1; i >= Math.max(0, caret - FAR); i--) {
      if (text.charAt(i) == '<') {
        return i;
      }
      if (ends(text, i + 1, "-->")) {
        return -1;
      }
    }
    return -1;
  }

  private static boolean closes(CharSequence text, int from, int caret, String close) {
    for (int i = from; i + close.length() <= caret; i++) {
      if (starts(text, i, close)) {
        return true;
      }
    }
    return false;
  }

  private static CaretContext nothing(int caret) {
    return new CaretContext(Kind.NOTHING, caret, "", "", ' ', Map.of());
  }

  private static CaretContext content(CharSequence text, int caret) {
    int from = caret;
    while (from > 0 && Character.isLetterOrDigit(text.charAt(from - 1))) {
      from--;
    }
    return new CaretContext(Kind.CONTENT, from, around(text, from), "", ' ', Map.of());
  }

  private static CaretContext inTag(CharSequence text, int open, int caret) {
    if (starts(text, open, "</")) {
      boolean closed = closes(text, open, caret, ">");
      return closed
          ? content(text, caret)
          : new CaretContext(Kind.END, open + 2, around(text, open), "", ' ', Map.of());
    }
    int at = open + 1;
    while (at < caret && named(text.charAt(at))) {
      at++;
    }
    if (at == caret) {
      return new CaretContext(Kind.NAME, open + 1, around(text, open), "", ' ', Map.of());
    }
    String name = text.subSequence(open + 1, at).toString();
    Map<String, String> given = new HashMap<>();
    while (true) {
      while (at < caret && text.charAt(at) <= ' ') {
        at++;
      }
      int word = at;
      while (at < caret && named(text.charAt(at))) {
        at++;
      }
      if (at == caret) {
        return new CaretContext(Kind.ATTRIBUTE, word, name, "", ' ', given);
      }
      if (text.charAt(at) == '>') {
        return content(text, caret);
      }
      String attribute = text.subSequence(word, at).toString();
      while (at < caret && text.charAt(at) != '"' && text.charAt(at) != '\'') {
        if (text.charAt(at) == '>') {
          return content(text, caret);
        }
        if (text.charAt(at) != '=' && text.charAt(at) > ' ') {
          return nothing(caret);
        }
        at++;
      }
      if (at == caret) {
        return nothing(caret);
      }
      char quote = text.charAt(at);
      int value = at + 1;
      at = value;
      while (at < caret && text.charAt(at) != quote) {
        at++;
      }
      if (at == caret) {
        return new CaretContext(Kind.VALUE, value, name, attribute, quote, given);
      }
      given.put(attribute, text.subSequence(value, at).toString());
      at++;
    }
  }

  private static boolean named(char c) {
    return Character.isLetterOrDigit(c) || c == '_' || c == '-' || c == '.' || c == ':';
  }

  /** Returns the innermost element that is open at an offset; empty for none. */
  private static String around(CharSequence text, int offset) {
    Deque<String> closed = new ArrayDeque<>();
    int at = offset;
    int last = Math.max(0, offset - FAR);
    while (at > last) {
      int open = at - 1;
      while (open >= last && text.charAt(open) != '<') {
        open = ends(text, open + 1, "-->") ? back(text, open, "<!--") : open - 1;
      }
      if (open < last) {
        return "";
      }
      String tag = word(text, open + (starts(text, open, "</") ? 2 : 1), offset);
      if (starts(text, open, "</")) {
        closed.push(tag);
      } else if (!tag.isEmpty() && !empty(text, open, at)) {
        if (closed.isEmpty()) {
          return tag;
        }
        closed.pop();
      }
      at = open;
    }
    return "";
  }

  private static int back(CharSequence text, int from, String word) {
    for (int i = from - 1; i >= 0; i--) {
      if (starts(text, i, word)) {
        return i - 1;
      }
    }
    return -1;
  }

  private static String word(CharSequence text, int from, int to) {
    int at = from;
    while (at < to && named(text.charAt(at))) {
      at++;
    }
    return text.subSequence(from, at).toString();
  }

  /** Returns whether the tag of a range is an empty-element tag. */
  private static boolean empty(CharSequence text, int open, int to) {
    char quote = 0;
    for (int i = open; i < to; i++) {
      char c = text.charAt(i);
      if (quote != 0) {
        quote = c == quote ? 0 : quote;
      } else if (c == '"' || c == '\'') {
        quote = c;
      } else if (c == '>') {
        return text.charAt(i - 1) == '/';
      }
    }
    return false;
  }

  private static boolean starts(CharSequence text, int at, String word) {
    return at >= 0 && ends(text, at + word.length(), word);
  }

  private static boolean ends(CharSequence text, int at, String word) {
    if (at < word.length() || at > text.length()) {
      return false;
    }
    for (int i = 0; i < word.length(); i++) {
      if (text.charAt(at - word.length() + i) != word.charAt(i)) {
        return false;
      }
    }
    return true;
  }
}
