package org.selectiverenderer.polygon.versions;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.selectiverenderer.x3d.SceneElement;

/** The Switch of an object's versions (thesis Figs 52 and 78). */
final class SwitchText {
  private static final Pattern DEF = Pattern.compile("(?s)\\sDEF\\s*=\\s*([\"']).*?\\1");

  private SwitchText() {}

  /**
   * The lines of a new Switch, the original shown; without the indentation of the first.
   *
   * @param switchName its DEF, and those of the Inlines
   */
  static List<String> lines(
      String switchName, List<String> inlineNames, List<String> urls, char quote, String step) {
    List<String> lines = new ArrayList<>();
    lines.add(
        "<Switch"
            + attribute("DEF", switchName, quote)
            + attribute("whichChoice", "0", quote)
            + ">");
    for (int i = 0; i < urls.size(); i++) {
      lines.add(
          step
              + "<Inline"
              + attribute("DEF", inlineNames.get(i), quote)
              + attribute("url", '"' + urls.get(i) + '"', '\'')
              + "/>");
    }
    lines.add("</Switch>");
    return lines;
  }

  private static String attribute(String name, String value, char quote) {
    return " " + name + "=" + quote + escape(value, quote) + quote;
  }

  static String escape(String value, char quote) {
    String escaped = value.replace("&", "&amp;").replace("<", "&lt;");
    return quote == '"' ? escaped.replace("\"", "&quot;") : escaped.replace("'", "&apos;");
  }

  /**
   * Another version's Inline, written as the last one is, without what stands in that.
   *
   * @param name its DEF, if the last one has any
   * @param url to be named if the last one is only a USE
   */
  static String further(
      TextEdits edits, SceneElement last, int lastNumber, int number, String name, String url) {
    if (last.attribute("USE").isPresent()) {
      return "<Inline"
          + attribute("DEF", name, edits.quote())
          + attribute("url", '"' + url + '"', '\'')
          + "/>";
    }
    String tag = tag(edits.source(last));
    // Before an ending that ends a url: Car_v2_v2.x3d has the number once.
    String turned =
        tag.replaceAll(
            "_v" + lastNumber + "(?=\\.[A-Za-z0-9]+(?:[\"'\\s#]|&quot;|&#))", "_v" + number);
    Matcher def = DEF.matcher(turned);
    return def.find()
        ? turned.substring(0, def.start())
            + attribute("DEF", name, def.group(1).charAt(0))
            + turned.substring(def.end())
        : turned;
  }

  /** An element's start tag, closed. */
  private static String tag(String source) {
    char quote = 0;
    for (int i = 0; i < source.length(); i++) {
      char c = source.charAt(i);
      if (quote != 0) {
        quote = c == quote ? 0 : quote;
      } else if (c == '"' || c == '\'') {
        quote = c;
      } else if (c == '>') {
        boolean closed = source.charAt(i - 1) == '/';
        return closed ? source.substring(0, i + 1) : source.substring(0, i) + "/>";
      }
    }
    return source;
  }
}
