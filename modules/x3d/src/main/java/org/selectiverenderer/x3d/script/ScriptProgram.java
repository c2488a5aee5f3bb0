package org.selectiverenderer.x3d.script;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.url.UrlContent;

/**
 * The text of a Script's program.
 *
 * @param text the ECMAScript text
 * @param start the location of its first character, in a scene or in a file of its own
 */
public record ScriptProgram(String text, SourceLocation start) {
  /** The maximum size of a program file in bytes. */
  public static final int MAX_BYTES = 4 << 20;

  /** The schemes of inline programs in a url (ISO/IEC 19777-1, 4.2; VRML97, C.1). */
  private static final Pattern SCHEME =
      Pattern.compile("\\A\\s*(?:ecmascript|javascript|vrmlscript):", Pattern.CASE_INSENSITIVE);

  private static final Pattern OTHER =
      Pattern.compile(
          "\\A\\s*(?:data:[a-z]+/(?:x-)?(?!ecma|java|vrml))?([a-z]+script|compiled)[:,;]",
          Pattern.CASE_INSENSITIVE);

  /** Returns the declared language, such as {@code castlescript}; empty for ECMAScript. */
  static Optional<String> otherLanguage(String text) {
    Matcher other = OTHER.matcher(text);
    return other.lookingAt() && !isText(text) ? Optional.of(other.group(1)) : Optional.empty();
  }

  /** Returns whether a url is an inline program. */
  static boolean isText(String url) {
    return SCHEME.matcher(url).lookingAt();
  }

  /** Returns the program of a text, without the scheme at its start, if any. */
  static ScriptProgram of(String text, SourceLocation start) {
    Matcher scheme = SCHEME.matcher(text);
    return new ScriptProgram(scheme.lookingAt() ? text.substring(scheme.end()) : text, start);
  }

  /** Returns the program of a Script's text or first url, if it is inline. */
  public static Optional<ScriptProgram> in(ParsedNode script) {
    String text = script.string("sourceCode");
    if (!text.isBlank() && otherLanguage(text).isEmpty()) {
      return Optional.of(of(text, script.textLocation()));
    }
    String[] urls = script.strings("url");
    return urls.length > 0 && isText(urls[0])
        ? Optional.of(of(urls[0], script.textLocation()))
        : Optional.empty();
  }

  /**
   * Reads a program's file.
   *
   * @throws IOException if it cannot be read or is larger than {@value #MAX_BYTES} bytes
   */
  public static ScriptProgram read(UrlContent file) throws IOException {
    return new ScriptProgram(
        new String(file.bytes(MAX_BYTES), StandardCharsets.UTF_8),
        new SourceLocation(file.name(), 1, 1));
  }

  /** Returns the location of a line of the text, counted from 1. */
  public SourceLocation line(int line) {
    if (line <= 1 || start.line() == 0) {
      return start;
    }
    return new SourceLocation(start.file(), start.line() + line - 1, 0);
  }
}
