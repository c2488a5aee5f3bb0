package org.selectiverenderer.authoring.editing;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Finds the DEF names of a text, which need not be well-formed. */
final class DefNameScanner {
  /** A comment, a tag that begins or ends the scope of a prototype, or a DEF name. */
  private static final Pattern PART =
      Pattern.compile(
          "(?s)<!--.*?-->|(<ProtoDeclare\\b)|(</ProtoDeclare\\b)"
              + "|\\sDEF\\s*=\\s*(?:\"([^\"<]*)\"|'([^'<]*)')");

  private DefNameScanner() {}

  /**
   * Returns the DEF names of the scope of an offset, with the names of their elements, in the order
   * of the text. The scope is the scene, or the declaration of the prototype around the offset.
   */
  static Map<String, String> of(CharSequence text, int offset) {
    Map<String, String> scene = new LinkedHashMap<>();
    Deque<Map<String, String>> around = new ArrayDeque<>();
    Map<String, String> scope = scene;
    Map<String, String> wanted = null;
    Matcher matcher = PART.matcher(text);
    while (matcher.find()) {
      if (wanted == null && matcher.start() >= offset) {
        wanted = scope;
      }
      if (matcher.group(1) != null) {
        around.push(scope);
        scope = new LinkedHashMap<>();
      } else if (matcher.group(2) != null) {
        scope = around.isEmpty() ? scope : around.pop();
      } else {
        String name = matcher.group(3) != null ? matcher.group(3) : matcher.group(4);
        if (name != null) {
          scope.putIfAbsent(name, element(text, matcher.start()));
        }
      }
    }
    return wanted == null ? scope : wanted;
  }

  private static String element(CharSequence text, int inTag) {
    int open = inTag;
    while (open > 0 && text.charAt(open) != '<') {
      open--;
    }
    int end = open + 1;
    while (end < inTag && Character.isLetterOrDigit(text.charAt(end))) {
      end++;
    }
    return text.subSequence(Math.min(open + 1, end), end).toString();
  }
}
