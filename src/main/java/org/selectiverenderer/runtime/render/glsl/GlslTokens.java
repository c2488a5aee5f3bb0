package org.selectiverenderer.runtime.render.glsl;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A text in GLSL as tokens: comments, the directives that must come first, names, and all else.
 *
 * @param list the tokens in order; their texts one after the other are the text
 */
record GlslTokens(List<Token> list) {
  private static final Pattern TOKEN =
      Pattern.compile(
          "(?<comment>//[^\\n]*+|/\\*[\\s\\S]*?(?:\\*/|\\z))"
              + "|(?<first>(?m:^)[ \\t]*#[ \\t]*(?:version|extension)\\b[^\\n]*)"
              + "|(?<name>[A-Za-z_]\\w*)"
              + "|(?<other>\\d[\\w.]*|[^A-Za-z_/#\\d\\n]+|[\\s\\S])");

  /** What a token is. */
  enum Kind {
    COMMENT,
    /** A line {@code #version} or {@code #extension}, without its end. */
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

  /** All names in it, those in directives included. */
  Set<String> names() {
    Set<String> names = new HashSet<>();
    for (Token token : list) {
      if (token.kind() == Kind.NAME) {
        names.add(token.text());
      }
    }
    return names;
  }

  /** The names that it gives to structures and macros itself. */
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
