package org.selectiverenderer.x3d.page;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.selectiverenderer.x3d.source.SourceText;

/** Finds the tags, comments and texts of a page, whether or not it is well-formed XML. */
final class HtmlTokenizer {
  /** Tells what a token is. */
  enum Kind {
    START_TAG,
    END_TAG,
    COMMENT,
    CHARACTER_DATA,
    OTHER,
    END
  }

  /**
   * An attribute.
   *
   * @param at the offset of its name
   * @param from the offset of its value; {@code to} if it has none
   */
  record Attribute(String name, int at, int from, int to) {}

  private final SourceText text;
  private final int length;
  private final int mostAttributes;
  private final List<Attribute> attributes = new ArrayList<>();
  private int at;
  private int start;
  private int contentFrom;
  private int contentTo;
  private String name = "";
  private boolean closed;

  /**
   * Creates a scanner at the start of a text.
   *
   * @param mostAttributes the number of attributes of a tag after which no more are stored
   */
  HtmlTokenizer(SourceText text, int mostAttributes) {
    this.text = text;
    this.length = text.length();
    this.mostAttributes = mostAttributes;
  }

  /** Returns the offset at which the found part begins. */
  int start() {
    return start;
  }

  /** Returns the offset after the found part. */
  int end() {
    return at;
  }

  /** Returns the name of the found tag as it is written. */
  String name() {
    return name;
  }

  /** Returns whether the found start tag is an empty element, {@code <name/>}. */
  boolean isClosed() {
    return closed;
  }

  /** Returns the attributes of the found start tag. */
  List<Attribute> attributes() {
    return attributes;
  }

  /** Returns the offset of the content of the found comment or text. */
  int contentFrom() {
    return contentFrom;
  }

  /** Returns the offset after the content of the found comment or text. */
  int contentTo() {
    return contentTo;
  }

  private boolean looking(String expected) {
    if (at + expected.length() > length) {
      return false;
    }
    for (int i = 0; i < expected.length(); i++) {
      if (text.charAt(at + i) != expected.charAt(i)) {
        return false;
      }
    }
    return true;
  }

  private int find(String wanted, int from) {
    for (int i = from; i + wanted.length() <= length; i++) {
      int k = 0;
      while (k < wanted.length() && lower(text.charAt(i + k)) == wanted.charAt(k)) {
        k++;
      }
      if (k == wanted.length()) {
        return i;
      }
    }
    return -1;
  }

  private static char lower(char c) {
    return c >= 'A' && c <= 'Z' ? (char) (c + 32) : c;
  }

  /** Goes to the next part and returns what it is. */
  Kind next() {
    start = at;
    if (at >= length) {
      return Kind.END;
    }
    if (text.charAt(at) != '<') {
      return characters();
    }
    if (looking("<!--")) {
      return delimited(4, "-->", Kind.COMMENT);
    }
    if (looking("<![CDATA[")) {
      return delimited(9, "]]>", Kind.CHARACTER_DATA);
    }
    if (looking("<!") || looking("<?")) {
      return delimited(2, ">", Kind.OTHER);
    }
    if (looking("</")) {
      at += 2;
      name = word();
      return delimited(at - start, ">", Kind.END_TAG);
    }
    at++;
    name = word();
    if (name.isEmpty()) {
      return characters();
    }
    readAttributes();
    return Kind.START_TAG;
  }

  private Kind characters() {
    contentFrom = start;
    at = Math.max(at, start);
    while (at < length && text.charAt(at) != '<') {
      at++;
    }
    contentTo = at;
    return Kind.CHARACTER_DATA;
  }

  private Kind delimited(int opening, String closing, Kind kind) {
    contentFrom = start + opening;
    int found = find(closing, contentFrom);
    contentTo = found < 0 ? length : found;
    at = found < 0 ? length : found + closing.length();
    return kind;
  }

  /** Goes to the end tag of an element whose content is no markup. */
  void skipRawText() {
    contentFrom = at;
    String end = "</" + name.toLowerCase(Locale.ROOT);
    int found = find(end, at);
    while (found >= 0 && !endsName(found + end.length())) {
      found = find(end, found + end.length());
    }
    at = found < 0 ? length : found;
    contentTo = at;
  }

  /** Returns whether the name of a tag ends before a place (WHATWG HTML, 13.2.5.14). */
  private boolean endsName(int place) {
    return place >= length || text.charAt(place) <= ' ' || "/>".indexOf(text.charAt(place)) >= 0;
  }

  private String word() {
    int from = at;
    while (at < length && text.charAt(at) > ' ' && "=/><\"'".indexOf(text.charAt(at)) < 0) {
      at++;
    }
    return text.subSequence(from, at).toString();
  }

  private void space() {
    while (at < length && text.charAt(at) <= ' ') {
      at++;
    }
  }

  private void readAttributes() {
    attributes.clear();
    closed = false;
    while (true) {
      space();
      if (at >= length || text.charAt(at) == '<') {
        return; // the tag is cut off
      }
      char c = text.charAt(at);
      if (c == '>') {
        at++;
        return;
      }
      closed = c == '/';
      int from = at;
      String found = word();
      if (found.isEmpty()) {
        at = from + 1;
        continue;
      }
      attribute(found, from);
    }
  }

  private void attribute(String found, int from) {
    int behind = at;
    space();
    int valueFrom = behind;
    int valueTo = behind;
    if (at < length && text.charAt(at) == '=') {
      at++;
      space();
      char quote = at < length ? text.charAt(at) : ' ';
      if (quote == '"' || quote == '\'') {
        valueFrom = ++at;
        while (at < length && text.charAt(at) != quote) {
          at++;
        }
        valueTo = at;
        at = Math.min(length, at + 1);
      } else {
        valueFrom = at;
        while (at < length && text.charAt(at) > ' ' && text.charAt(at) != '>') {
          at++;
        }
        valueTo = at;
      }
    } else {
      at = behind;
    }
    if (attributes.size() <= mostAttributes) {
      attributes.add(new Attribute(found, from, valueFrom, valueTo));
    }
  }
}
