package org.selectiverenderer.authoring.editing;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Finds the DEF names of a text, which need not be well-formed. */
final class DefNameScanner {
  private static final Pattern DEF = Pattern.compile("\\sDEF\\s*=\\s*(?:\"([^\"<]*)\"|'([^'<]*)')");

  private DefNameScanner() {}

  /** Returns the DEF names with the names of their elements, in the order of the text. */
  static Map<String, String> of(CharSequence text) {
    Map<String, String> names = new LinkedHashMap<>();
    Matcher matcher = DEF.matcher(text);
    while (matcher.find()) {
      String name = matcher.group(1) != null ? matcher.group(1) : matcher.group(2);
      names.putIfAbsent(name, element(text, matcher.start()));
    }
    return names;
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
