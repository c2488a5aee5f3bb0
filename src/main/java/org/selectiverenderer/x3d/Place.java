package org.selectiverenderer.x3d;

/**
 * Where an element starts in its file. Places within its start tag are found by reading the tag
 * once more, which costs nothing as long as nothing is wrong.
 *
 * @param offset of the tag's {@code <}
 */
record Place(SourceText text, int offset, Location location) {

  /** The name of the attribute of that index, namespace declarations not counted. */
  Location attribute(int index) {
    return new Walk().find(index, -1);
  }

  /** A character of its value, counted from the first that is no white space. */
  Location inAttribute(int index, int offset) {
    return new Walk().find(index, offset);
  }

  /** The value of the attribute of that index as it is written, references and all. */
  String attributeText(int index) {
    Walk walk = new Walk();
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
    private int at = offset;
    private int line = location.line();
    private int column = location.column();
    private char quote;

    Location find(int index, int inValue) {
      step();
      name();
      for (int found = -1; ; ) {
        space();
        int line = this.line;
        int column = this.column;
        String name = name();
        if (name.isEmpty()) {
          return location;
        }
        if (!name.equals("xmlns") && !name.startsWith("xmlns:")) {
          found++;
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
