package org.selectiverenderer.document.versions;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.selectiverenderer.document.Layout;

/** The Switch of an object's versions (thesis Figs 52 and 78). */
final class VersionSwitch {
  private static final Pattern DEF = Pattern.compile("(?s)\\sDEF\\s*=\\s*([\"']).*?\\1");

  private VersionSwitch() {}

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
            + Layout.written("DEF", switchName, quote)
            + Layout.written("whichChoice", "0", quote)
            + ">");
    for (int i = 0; i < urls.size(); i++) {
      lines.add(step + inline(inlineNames.get(i), urls.get(i), quote));
    }
    lines.add("</Switch>");
    return lines;
  }

  /** An Inline; its url stands in double quotes, so these are not around it. */
  static String inline(String name, String url, char quote) {
    return "<Inline"
        + Layout.written("DEF", name, quote)
        + Layout.written("url", '"' + url + '"', '\'')
        + "/>";
  }

  /**
   * Another version's Inline, written as the last one is, without what stands in that.
   *
   * @param tag of the last one
   * @param name its DEF, if the last one has any
   */
  static String further(String tag, int lastNumber, int number, String name) {
    // Before an ending that ends a url: Car_v2_v2.x3d has the number once.
    String turned =
        closed(tag)
            .replaceAll(
                "_v" + lastNumber + "(?=\\.[A-Za-z0-9]+(?:[\"'\\s#]|&quot;|&#))", "_v" + number);
    Matcher def = DEF.matcher(turned);
    return def.find()
        ? turned.substring(0, def.start())
            + Layout.written("DEF", name, def.group(1).charAt(0))
            + turned.substring(def.end())
        : turned;
  }

  private static String closed(String tag) {
    return tag.endsWith("/>") ? tag : tag.substring(0, tag.length() - 1) + "/>";
  }
}
