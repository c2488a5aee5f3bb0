package org.selectiverenderer.polygon.versions;

import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.x3d.SceneElement;

/** The Switch of an object's versions (thesis Figs 52 and 78). */
final class SwitchText {
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
    String escaped = value.replace("&", "&amp;").replace("<", "&lt;");
    escaped = quote == '"' ? escaped.replace("\"", "&quot;") : escaped.replace("'", "&apos;");
    return " " + name + "=" + quote + escaped + quote;
  }

  /** Another version's Inline, written as the last one is. */
  static String further(TextEdits edits, SceneElement last, int lastNumber, int number) {
    return edits.source(last).replace("_v" + lastNumber, "_v" + number);
  }
}
