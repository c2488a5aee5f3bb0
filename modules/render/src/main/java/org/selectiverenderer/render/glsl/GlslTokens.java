package org.selectiverenderer.render.glsl;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The tokens of a GLSL source: comments, the directives that must come first, names, and all else.
 *
 * @param list the tokens in order; their concatenation is the source
 */
record GlslTokens(List<Token> list) {
  private static final Pattern TOKEN =
      Pattern.compile(
          "(?<comment>//[^\\n]*+|/\\*[\\s\\S]*?(?:\\*/|\\z))"
              + "|(?<first>(?m:^)[ \\t]*#[ \\t]*(?:version|extension)\\b[^\\n]*)"
              + "|(?<name>[A-Za-z_]\\w*)"
              + "|(?<other>\\d[\\w.]*|[^A-Za-z_/#\\d\\n]+|[\\s\\S])");

  /** The kind of a token. */
  enum Kind {
    COMMENT,
    /** A line {@code #version} or {@code #extension}, without its line break. */
    FIRST,
    NAME,
    OTHER
  }

  record Token(Kind kind, String text) {}

  static GlslTokens of(String text) {
    List<Token> list = new ArrayList<>();
    Matcher token = TOKEN.matcher(text);
    while (token.find()) {
      Kind kind =
          token.group("comment") != null
              ? Kind.COMMENT
              : token.group("first") != null
                  ? Kind.FIRST
                  : token.group("name") != null ? Kind.NAME : Kind.OTHER;
      list.add(new Token(kind, token.group()));
    }
    return new GlslTokens(list);
  }

  /** Returns all names in the source, including those in directives. */
  Set<String> names() {
    Set<String> names = new HashSet<>();
    for (Token token : list) {
      if (token.kind() == Kind.NAME) {
        names.add(token.text());
      }
    }
    return names;
  }

  /** Returns the names of structures and macros that the source defines. */
  Set<String> defined() {
    Set<String> defined = new HashSet<>();
    String before = "";
    for (Token token : list) {
      if (token.kind() == Kind.NAME) {
        if (before.equals("struct") || before.equals("define")) {
          defined.add(token.text());
        }
        before = token.text();
      } else if (token.kind() == Kind.OTHER && !token.text().isBlank()) {
        before = "";
      }
    }
    return defined;
  }
}
