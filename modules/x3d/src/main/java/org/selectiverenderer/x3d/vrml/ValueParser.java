package org.selectiverenderer.x3d.vrml;

import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.ElementTreeBuilder;
import org.selectiverenderer.x3d.source.XmlParseException;

/** Finds the extent of field values other than nodes, and adds them as attributes. */
final class ValueParser {
  private final ElementTreeBuilder document;
  private final VrmlScanner scanner;

  /** The offset of the first word of the last list; -1 for a value without brackets. */
  private int firstInList = -1;

  ValueParser(ElementTreeBuilder document, VrmlScanner scanner) {
    this.document = document;
    this.scanner = scanner;
  }

  /**
   * Adds the value at the current offset as an attribute.
   *
   * @param attribute the name of the attribute
   * @param at the offset of the field's name
   */
  void value(String attribute, FieldType type, int at) throws XmlParseException {
    int from = scanner.space();
    switch (type.kind()) {
      case STRING -> {
        if (type.multiple()) {
          strings(attribute, at);
        } else {
          String string = scanner.string("a string in double quotes");
          document.attribute(attribute, string, at, from + 1, scanner.at() - 1);
        }
      }
      case BOOLEAN -> {
        int to = words(type);
        int first = first(from);
        String words = document.value(first, Math.max(first, to));
        // only the keywords of the grammar; other spellings are reported as written
        String spelled = words.replaceAll("\\bTRUE\\b", "true").replaceAll("\\bFALSE\\b", "false");
        document.attribute(attribute, spelled, at, first, Math.max(first, to));
      }
      default -> {
        int to = words(type);
        int first = first(from);
        document.attribute(attribute, at, first, Math.max(first, to));
      }
    }
  }

  /** Returns the offset of a value's first word, after the bracket, if any. */
  private int first(int from) {
    return firstInList >= 0 ? firstInList : from;
  }

  /** Skips numbers or booleans; returns the offset after the last. */
  private int words(FieldType type) throws XmlParseException {
    if (scanner.peek() == '[') {
      return list();
    }
    firstInList = -1;
    boolean flags = type.kind() == FieldType.Kind.BOOLEAN;
    int end = scanner.at();
    scanner.space();
    // a wrong word in the place of a value is reported, and parsing goes on
    if (!flag() && stray()) {
      scanner.passWord();
      end = scanner.at();
      scanner.space();
    }
    while (flags && flag() || scanner.number() || notFinite()) {
      scanner.passWord();
      end = scanner.at();
      scanner.space();
    }
    return end;
  }

  private boolean flag() {
    int start = scanner.at();
    boolean found =
        scanner.take("TRUE")
            || scanner.take("FALSE")
            || scanner.take("true")
            || scanner.take("false");
    scanner.back(start);
    return found;
  }

  private boolean notFinite() {
    int start = scanner.at();
    boolean found = VrmlScanner.isNotFinite(scanner.word());
    scanner.back(start);
    return found;
  }

  /**
   * Returns whether the word in the place of a value is neither a value nor a field name, as no
   * value follows it: {@code abc}. It is reported as an invalid value, and parsing goes on.
   */
  private boolean stray() {
    int start = scanner.at();
    String word = scanner.word();
    boolean stray =
        switch (word) {
          case "", "DEF", "USE", "NULL", "ROUTE", "PROTO", "EXTERNPROTO", "IMPORT", "EXPORT" ->
              false;
          default ->
              !VrmlScanner.isNumber(word)
                  && StatementParser.access(word) == null
                  && !valueFollows();
        };
    scanner.back(start);
    return stray;
  }

  private boolean valueFollows() {
    scanner.look();
    switch (scanner.peek()) {
      case '"', '[', '{', 0 -> {
        return true;
      }
      case '}', ']' -> {
        return false;
      }
      default -> {
        String word = scanner.word();
        return switch (word) {
          case "TRUE", "FALSE", "true", "false", "IS", "DEF", "USE", "NULL" -> true;
          default -> VrmlScanner.isNumber(word) || scanner.opens();
        };
      }
    }
  }

  /** Skips a list in brackets; returns the offset of the closing bracket. */
  private int list() throws XmlParseException {
    int open = scanner.at();
    scanner.step();
    firstInList = scanner.space();
    while (true) {
      scanner.space();
      char c = scanner.peek();
      switch (c) {
        case ']' -> {
          int end = scanner.at();
          scanner.step();
          return end;
        }
        case '"' -> scanner.passString();
        case '[', '{', '}', 0 ->
            throw document.fault(open, "the list that begins here has no closing ']'");
        default -> scanner.passWord();
      }
    }
  }

  private void strings(String attribute, int at) throws XmlParseException {
    int from = scanner.at();
    int to;
    if (scanner.peek() == '[') {
      to = list();
      from = firstInList;
    } else if (scanner.peek() == '"') {
      to = scanner.passString() + 1;
    } else {
      throw scanner.expected("a string in double quotes, or a list of strings in brackets,");
    }
    String strings = document.value(from, Math.max(from, to));
    String lines = strings.indexOf('\r') < 0 ? strings : strings.replaceAll("\r\n?", "\n");
    document.attribute(attribute, lines, at, from, Math.max(from, to));
  }

  /** Parses a bare word that does not begin a node, such as an enumeration of some programs. */
  private boolean name(String attribute, int at) {
    int from = scanner.at();
    String word = scanner.word();
    int to = scanner.at();
    boolean begins =
        switch (word) {
          case "", "DEF", "USE", "NULL", "ROUTE", "PROTO", "EXTERNPROTO" -> true;
          default -> scanner.opens();
        };
    scanner.back(from);
    if (!begins) {
      scanner.passWord();
      document.attribute(attribute, word, at, from, to);
    }
    return !begins;
  }

  /** Returns whether there is a number or a list of numbers here. */
  boolean numbers() {
    int from = scanner.space();
    boolean list = scanner.peek() == '[';
    if (list) {
      scanner.step();
      scanner.look();
    }
    boolean found = scanner.number();
    scanner.back(from);
    return found;
  }

  /**
   * Adds the value of an unknown field as an attribute.
   *
   * @return false, without consuming anything, if it may consist of nodes
   */
  boolean guess(String attribute, int at) throws XmlParseException {
    int from = scanner.space();
    if (scanner.peek() == '[') {
      scanner.step();
      scanner.look();
      char c = scanner.peek();
      boolean values = c == ']' || c == '"' || scanner.number() || flag();
      scanner.back(from);
      if (values) {
        int to = list();
        String words = document.value(firstInList, Math.max(firstInList, to));
        document.attribute(attribute, words, at, firstInList, Math.max(firstInList, to));
      }
      return values;
    }
    if (scanner.peek() == '"') {
      document.attribute(attribute, scanner.string("a string"), at, from + 1, scanner.at() - 1);
      return true;
    }
    boolean flags = flag();
    if (!flags && !scanner.number()) {
      return name(attribute, at);
    }
    int to = words(flags ? FieldType.SFBool : FieldType.SFFloat);
    document.attribute(attribute, document.value(from, to), at, from, to);
    return true;
  }
}
