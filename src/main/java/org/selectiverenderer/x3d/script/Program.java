package org.selectiverenderer.x3d.script;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.selectiverenderer.base.problem.Location;

/**
 * The text of a Script's program.
 *
 * @param text ECMAScript
 * @param start where its first character stands: in a scene, or in a file of its own
 */
public record Program(String text, Location start) {
  /** The schemes of programs that stand in a url (ISO/IEC 19777-1, 4.2; VRML97, C.1). */
  private static final Pattern SCHEME =
      Pattern.compile("\\A\\s*(?:ecmascript|javascript|vrmlscript):", Pattern.CASE_INSENSITIVE);

  /** Whether a url is a program itself. */
  static boolean isText(String url) {
    return SCHEME.matcher(url).lookingAt();
  }

  /** A program that may begin with a scheme, as texts in scenes do. */
  static Program of(String text, Location start) {
    Matcher scheme = SCHEME.matcher(text);
    return new Program(scheme.lookingAt() ? text.substring(scheme.end()) : text, start);
  }

  /** Where a line of the text stands, counted from 1. */
  public Location line(int line) {
    if (line <= 1 || start.line() == 0) {
      return start;
    }
    return new Location(start.file(), start.line() + line - 1, 0);
  }
}
