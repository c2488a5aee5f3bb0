package org.selectiverenderer.x3d;

import org.codehaus.stax2.XMLStreamLocation2;
import org.codehaus.stax2.XMLStreamReader2;

/**
 * Where an element starts in its file. Places within its start tag are found by reading the tag
 * once more, which costs nothing as long as nothing is wrong; who asks for one attribute after the
 * other goes through the tag once. Serves one thread.
 */
final class Place {
  private final SourceText text;
  private final int offset;
  private final Location location;
  private Mark mark;

  /** The name of an attribute that has been found, or the tag's start before the first one. */
  private record Mark(int attribute, int at, int line, int column) {}

  /**
   * @param offset of the tag's {@code <}
   * @param location of the same
   */
  Place(SourceText text, int offset, Location location) {
    this.text = text;
    this.offset = offset;
    this.location = location;
    this.mark = start();
  }

  /** Where the parser's current event starts: in front of the root it counts white space to it. */
  static Place of(SourceText text, String file, XMLStreamReader2 xml) {
    XMLStreamLocation2 at = xml.getLocationInfo().getStartLocation();
    int offset = at.getCharacterOffset();
    int line = at.getLineNumber();
    int column = at.getColumnNumber();
    for (; offset < text.length() && text.charAt(offset) <= ' '; offset++) {
      char c = text.charAt(offset);
      boolean first = c == '\r' && offset + 1 < text.length() && text.charAt(offset + 1) == '\n';
      column = c == '\n' || c == '\r' ? 1 : column + 1;
      line += (c == '\n' || c == '\r') && !first ? 1 : 0;
    }
    return new Place(text, offset, new Location(file, line, column));
  }

  private Mark start() {
    return new Mark(-1, offset, location.line(), location.column());
  }

  /** Where the tag starts. */
  Location location() {
    return location;
  }

  /** The offset of the tag's {@code <}. */
  int offset() {
    return offset;
  }

  /** The name of the attribute of that index, namespace declarations not counted. */
  Location attribute(int index) {
    return walk(index).find(index, -1);
  }

  /** The name of that attribute with its prefix; empty if there is none. */
  String attributeName(int index) {
    Walk walk = walk(index);
    walk.find(index, -1);
    return walk.last;
  }

  /** A character of its value, counted from the first that is no white space. */
  Location inAttribute(int index, int offset) {
    return walk(index).find(index, offset);
  }

  private Walk walk(int index) {
    return new Walk(mark.attribute <= index ? mark : start());
  }

  /** The value of the attribute of that index as it is written, references and all. */
  String attributeText(int index) {
    Walk walk = walk(index);
    walk.find(index, 0);
    int start = walk.at;
    while (!walk.ended() && walk.peek() != walk.quote) {
      walk.at++;
    }
    StringBuilder value = new StringBuilder(walk.at - start);
    for (int i = start; i < walk.at; i++) {
      value.append(text.charAt(i));
    }
    return value.toString();
  }

  /** Steps through the start tag and keeps count of lines and columns. */
  private final class Walk {
    private int at;
    private int line;
    private int column;
    private int found;
    private char quote;
    private String last = "";

    Walk(Mark from) {
      at = from.at;
      line = from.line;
      column = from.column;
      found = from.attribute;
      if (found < 0) {
        step();
        name();
      } else {
        found--; // It is found again.
      }
    }

    Location find(int index, int inValue) {
      while (true) {
        space();
        int start = at;
        int line = this.line;
        int column = this.column;
        String name = name();
        last = name;
        if (name.isEmpty()) {
          return location;
        }
        if (!name.equals("xmlns") && !name.startsWith("xmlns:")) {
          found++;
          mark = new Mark(found, start, line, column);
        }
        if (found == index && inValue < 0) {
          return new Location(location.file(), line, column);
        }
        space();
        step();
        space();
        quote = peek();
        step();
        if (found == index) {
          return value(inValue);
        }
        while (!ended() && peek() != quote) {
          step();
        }
        step();
      }
    }

    private Location value(int offset) {
      space();
      for (int i = 0; i < offset && !ended() && peek() != quote; i++) {
        // A reference is one character, two beyond the basic plane.
        if (peek() == '&') {
          int start = at;
          while (!ended() && peek() != ';') {
            step();
          }
          i += reference(start) > 0xffff ? 1 : 0;
        }
        step();
      }
      return new Location(location.file(), line, column);
    }

    private int reference(int start) {
      int code = 0;
      boolean hexadecimal = text.charAt(Math.min(start + 2, at - 1)) == 'x';
      if (text.charAt(start + 1) != '#') {
        return code;
      }
      for (int i = start + (hexadecimal ? 3 : 2); i < at && code <= 0x10ffff; i++) {
        int digit = Character.digit(text.charAt(i), 16);
        code = code * (hexadecimal ? 16 : 10) + Math.max(0, digit);
      }
      return code;
    }

    private String name() {
      StringBuilder name = new StringBuilder();
      while (!ended() && "=/>\"'".indexOf(peek()) < 0 && peek() > ' ') {
        name.append(peek());
        step();
      }
      return name.toString();
    }

    private void space() {
      while (!ended() && peek() <= ' ') {
        step();
      }
    }

    private boolean ended() {
      return at >= text.length();
    }

    private char peek() {
      return ended() ? '>' : text.charAt(at);
    }

    /** One character on; CR LF is one character, as XML reads it (XML 1.0, 2.11). */
    private void step() {
      if (ended()) {
        return;
      }
      char c = text.charAt(at++);
      if (c == '\r' && at < text.length() && text.charAt(at) == '\n') {
        at++;
      }
      if (c == '\n' || c == '\r') {
        line++;
        column = 1;
      } else {
        column++;
      }
    }
  }
}
