package org.selectiverenderer.x3d.vrml;

import java.util.Locale;
import org.selectiverenderer.x3d.field.FieldTokenizer;
import org.selectiverenderer.x3d.source.ElementTreeBuilder;
import org.selectiverenderer.x3d.source.SourceText;
import org.selectiverenderer.x3d.source.XmlParseException;

/**
 * Scans the lexical elements of a text (ISO/IEC 19776-2, 4.3), which are separated by white space,
 * commas, brackets and quotes. VRML 1.0 has the same ones.
 */
public final class VrmlScanner {
  /** Receives comments when they are skipped. */
  @FunctionalInterface
  public interface Comments {
    /**
     * Receives a comment.
     *
     * @param words the characters after the {@code #}
     * @param at the offset of the {@code #}
     */
    void comment(String words, int at);
  }

  private final ElementTreeBuilder document;
  private final Comments comments;
  private final SourceText text;
  private final int length;
  private int at;

  VrmlScanner(ElementTreeBuilder document) {
    this(document, document::comment);
  }

  /** Creates a scanner of a document's text at its start. */
  public VrmlScanner(ElementTreeBuilder document, Comments comments) {
    this.document = document;
    this.comments = comments;
    this.text = document.text();
    this.length = text.length();
  }

  /** Returns the offset of the next character. */
  public int at() {
    return at;
  }

  /** Returns whether the text has ended. */
  public boolean ended() {
    return at >= length;
  }

  /** Returns the next character; 0 at the end. */
  public char peek() {
    return at < length ? text.charAt(at) : 0;
  }

  /** Skips a character. */
  public void step() {
    at++;
  }

  /** Goes to an offset. */
  public void back(int offset) {
    at = offset;
  }

  /** Skips white space, commas and comments; returns the offset after them. */
  public int space() {
    while (at < length) {
      char c = text.charAt(at);
      if (c == '#') {
        comment();
      } else if (c > ' ' && c != ',') {
        return at;
      } else {
        at++;
      }
    }
    return at;
  }

  /** Returns the next word without consuming anything. */
  String nextWord() {
    int start = at;
    look();
    String word = word();
    at = start;
    return word;
  }

  /** Returns whether an opening brace is next, without consuming anything. */
  public boolean opens() {
    int start = at;
    look();
    boolean found = peek() == '{';
    at = start;
    return found;
  }

  /** Skips as {@link #space} does, without adding comments to the document. */
  void look() {
    while (at < length && (peek() <= ' ' || peek() == ',' || peek() == '#')) {
      if (peek() == '#') {
        line();
      } else {
        at++;
      }
    }
  }

  private void comment() {
    int start = at;
    line();
    comments.comment(text.subSequence(start + 1, at).toString(), start);
  }

  /** Consumes the rest of a line and returns it. */
  public String line() {
    int start = at;
    while (at < length && text.charAt(at) != '\n' && text.charAt(at) != '\r') {
      at++;
    }
    return text.subSequence(start, at).toString();
  }

  /** Returns whether a character ends a word. */
  private static boolean ends(char c) {
    return c <= ' '
        || switch (c) {
          case ',', '#', '"', '[', ']', '{', '}' -> true;
          default -> false;
        };
  }

  /** Consumes the word that begins here and returns it; empty if there is none. */
  public String word() {
    int start = at;
    passWord();
    return text.subSequence(start, at).toString();
  }

  /** Skips the word that begins here. */
  public void passWord() {
    while (at < length && !ends(text.charAt(at))) {
      at++;
    }
  }

  /** Consumes the word that begins here up to a mark, and returns it. */
  String word(char mark) {
    int start = at;
    while (at < length && text.charAt(at) != mark && !ends(text.charAt(at))) {
      at++;
    }
    return text.subSequence(start, at).toString();
  }

  /** Consumes a word if it is here, and returns whether it is. */
  boolean take(String word) {
    int end = at + word.length();
    if (end > length || end < length && !ends(text.charAt(end))) {
      return false;
    }
    for (int i = 0; i < word.length(); i++) {
      if (text.charAt(at + i) != word.charAt(i)) {
        return false;
      }
    }
    at = end;
    return true;
  }

  /** Returns whether a number begins here. */
  public boolean number() {
    return beginsNumber(peek());
  }

  private static boolean beginsNumber(char c) {
    return c >= '0' && c <= '9' || c == '-' || c == '+' || c == '.';
  }

  /** Returns whether a word is a number, NaN or infinity. */
  static boolean isNumber(String word) {
    return !word.isEmpty() && beginsNumber(word.charAt(0)) || isNotFinite(word);
  }

  /** Returns whether a word is NaN or infinity as written by programs. */
  static boolean isNotFinite(String word) {
    return switch (word.toLowerCase(Locale.ROOT)) {
      case "nan", "inf", "infinity" -> true;
      default -> false;
    };
  }

  /**
   * Consumes a word that must be there and returns it.
   *
   * @param what the noun for it with its article, for the message
   */
  public String name(String what) throws XmlParseException {
    space();
    String name = word();
    if (name.isEmpty()) {
      throw expected(what);
    }
    return name;
  }

  /** Consumes a character that must be there. */
  public void expect(char wanted, String where) throws XmlParseException {
    space();
    if (peek() != wanted) {
      throw expected("'" + wanted + "' " + where);
    }
    at++;
  }

  /** Returns the error that something else is expected here. */
  public XmlParseException expected(String what) {
    if (ended()) {
      return document.fault(at, "the file is cut off here: " + what + " is missing");
    }
    int start = at;
    passWord();
    String found = text.subSequence(start, Math.max(at, start + 1)).toString();
    at = start;
    return document.fault(start, what + " is expected here, not " + FieldTokenizer.quote(found));
  }

  /**
   * Skips the string that begins here.
   *
   * @return the offset of its closing quote
   */
  public int passString() throws XmlParseException {
    int start = at++;
    while (at < length && text.charAt(at) != '"') {
      at += text.charAt(at) == '\\' ? 2 : 1;
    }
    if (at >= length) {
      at = length;
      throw document.fault(start, "the string that begins here has no closing quote");
    }
    return at++;
  }

  /** Consumes a string and returns its unescaped content, with XML line ends (XML 1.0, 2.11). */
  public String string(String what) throws XmlParseException {
    space();
    if (peek() != '"') {
      throw expected(what);
    }
    int start = at + 1;
    return unescaped(text.subSequence(start, passString()).toString());
  }

  /** Returns the content of a string as it is meant, with XML line ends. */
  public static String unescaped(String written) {
    if (written.indexOf('\\') < 0 && written.indexOf('\r') < 0) {
      return written;
    }
    StringBuilder plain = new StringBuilder(written.length());
    for (int i = 0; i < written.length(); i++) {
      char c = written.charAt(i);
      char next = i + 1 < written.length() ? written.charAt(i + 1) : 0;
      if (c == '\\' && (next == '"' || next == '\\')) {
        plain.append(next);
        i++;
      } else if (c == '\r') {
        plain.append('\n');
        i += next == '\n' ? 1 : 0;
      } else {
        plain.append(c);
      }
    }
    return plain.toString();
  }

  /** Replaces comments outside quotes by blanks. */
  public static void clean(char[] value, int length) {
    boolean quoted = false;
    for (int i = 0; i < length; i++) {
      char c = value[i];
      if (c == '"') {
        quoted = !quoted;
      } else if (quoted && c == '\\') {
        i++;
      } else if (!quoted && c == '#') {
        while (i < length && value[i] != '\n' && value[i] != '\r') {
          value[i++] = ' ';
        }
      }
    }
  }
}
