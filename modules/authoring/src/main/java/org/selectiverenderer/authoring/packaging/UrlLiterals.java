package org.selectiverenderer.authoring.packaging;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.authoring.MFStringParser;
import org.selectiverenderer.authoring.packaging.UrlFields.UrlField;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.TextEdit;

/**
 * Finds the string literals of a url field in a text in VRML or JSON: those that follow the field's
 * own name in its own element, so that equal strings of other fields, names and comments stay.
 */
final class UrlLiterals {
  /** The fields of VRML 1.0 that hold urls. */
  private static final Set<String> VRML1 = Set.of("filename", "name");

  private final CharSequence text;
  private final boolean json;
  private final boolean vrml1;
  private int at;

  /** A token with its place; {@code value} is decoded where it is a string. */
  private record Token(char kind, String value, int from, int to) {
    private static final char WORD = 'w';
    private static final char STRING = '"';
    private static final char END = 0;

    boolean is(char other) {
      return kind == other;
    }
  }

  UrlLiterals(CharSequence text, boolean json) {
    this.text = text;
    this.json = json;
    this.vrml1 = !json && text.toString().startsWith("#VRML V1.");
  }

  /** Returns the changes that give a field other urls; empty if its literals are not found. */
  Optional<List<TextEdit>> changed(UrlField field, List<String> urls) {
    return values(field).flatMap(literals -> edits(literals, field.urls(), urls));
  }

  private Optional<List<TextEdit>> edits(List<Token> literals, List<String> was, List<String> now) {
    if (literals.stream().map(Token::value).toList().equals(was)) {
      List<TextEdit> edits = new ArrayList<>();
      for (int i = 0; i < was.size(); i++) {
        if (!was.get(i).equals(now.get(i))) {
          edits.add(new TextEdit(literals.get(i).from(), literals.get(i).to(), quoted(now.get(i))));
        }
      }
      return Optional.of(edits);
    }
    // JSON also has all of them in one string, as XML does.
    if (json
        && literals.size() == 1
        && MFStringParser.strings(literals.get(0).value()).equals(was)) {
      String all = String.join(" ", now.stream().map(UrlLiterals::plainlyQuoted).toList());
      return Optional.of(
          List.of(new TextEdit(literals.get(0).from(), literals.get(0).to(), quoted(all))));
    }
    return Optional.empty();
  }

  /** Returns the literals behind the name of a field. */
  private Optional<List<Token>> values(UrlField field) {
    DocumentElement element = field.element();
    boolean own = element.name().equals("field") || element.name().equals("fieldValue");
    boolean extern = element.name().equals("ExternProtoDeclare") && !json;
    String name = own && !json ? element.text("name").orElse("") : field.attribute();
    int wanted = json || !own && !extern ? 1 : 0;
    at = Math.max(0, element.start());
    int end = element.end() > at ? element.end() : text.length();
    int depth = 0;
    for (Token token = next(); !token.is(Token.END) && token.from() < end; token = next()) {
      switch (token.kind()) {
        case '{', '[' -> depth++;
        case '}', ']' -> depth--;
        default -> {}
      }
      boolean behind = extern ? token.is(']') : named(token, name);
      if (depth == wanted && behind) {
        int here = at;
        List<Token> literals = list();
        if (!literals.isEmpty()) {
          return Optional.of(literals);
        }
        at = here;
      }
    }
    return Optional.empty();
  }

  private boolean named(Token token, String name) {
    if (json) {
      return token.is(Token.STRING) && token.value().equals("@" + name);
    }
    return token.is(Token.WORD)
        && (token.value().equals(name) || vrml1 && VRML1.contains(token.value()));
  }

  private List<Token> list() {
    List<Token> found = new ArrayList<>();
    Token token = next();
    if (json) {
      if (!token.is(':')) {
        return found; // a value, not a name
      }
      token = next();
    }
    boolean several = token.is('[');
    if (several) {
      token = next();
    }
    while (token.is(Token.STRING)) {
      found.add(token);
      if (!several) {
        break;
      }
      token = next();
    }
    return found;
  }

  private Token next() {
    skip();
    if (at >= text.length()) {
      return new Token(Token.END, "", at, at);
    }
    int from = at;
    char first = text.charAt(at++);
    if (first == '"') {
      String value = string();
      return new Token(Token.STRING, value, from, at);
    }
    if (delimiter(first)) {
      return new Token(first, "", from, at);
    }
    while (at < text.length()
        && !delimiter(text.charAt(at))
        && text.charAt(at) > ' '
        && text.charAt(at) != ','
        && text.charAt(at) != '"'
        && text.charAt(at) != '#') {
      at++;
    }
    return new Token(Token.WORD, text.subSequence(from, at).toString(), from, at);
  }

  private boolean delimiter(char character) {
    return "{}[]".indexOf(character) >= 0 || json && character == ':';
  }

  private void skip() {
    while (at < text.length()) {
      char now = text.charAt(at);
      if (now == '#' && !json) {
        while (at < text.length() && text.charAt(at) != '\n' && text.charAt(at) != '\r') {
          at++;
        }
      } else if (now <= ' ' || now == ',') {
        at++;
      } else {
        return;
      }
    }
  }

  /** Reads a string behind its first quote. */
  private String string() {
    StringBuilder value = new StringBuilder();
    while (at < text.length() && text.charAt(at) != '"') {
      char now = text.charAt(at++);
      if (now == '\\' && at < text.length()) {
        now = escaped(text.charAt(at++));
      }
      value.append(now);
    }
    at = Math.min(at + 1, text.length());
    return value.toString();
  }

  private char escaped(char letter) {
    if (!json) {
      return letter;
    }
    return switch (letter) {
      case 'n' -> '\n';
      case 't' -> '\t';
      case 'r' -> '\r';
      case 'b' -> '\b';
      case 'f' -> '\f';
      case 'u' -> {
        int to = Math.min(at + 4, text.length());
        String digits = text.subSequence(at, to).toString();
        at = to;
        yield digits.matches("[0-9A-Fa-f]{4}") ? (char) Integer.parseInt(digits, 16) : '?';
      }
      default -> letter;
    };
  }

  private String quoted(String value) {
    String plain = plainlyQuoted(value);
    if (!json) {
      return plain;
    }
    StringBuilder out = new StringBuilder();
    for (char each : plain.toCharArray()) {
      out.append(each < ' ' ? "\\u%04x".formatted((int) each) : String.valueOf(each));
    }
    return out.toString();
  }

  /** Returns a string in quotes, with those in it and backslashes escaped. */
  static String plainlyQuoted(String value) {
    return '"' + value.replace("\\", "\\\\").replace("\"", "\\\"") + '"';
  }
}
