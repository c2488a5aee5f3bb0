package org.selectiverenderer.authoring.versions;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.selectiverenderer.authoring.SourceFormatter;

/** Writes the Switch of an object's versions (thesis Figs 52 and 78). */
final class VersionSwitchWriter {
  private static final Pattern DEF = Pattern.compile("(?s)\\sDEF\\s*=\\s*([\"']).*?\\1");

  private VersionSwitchWriter() {}

  /**
   * Returns the lines of a new Switch that shows the original, without the indentation of the first
   * line.
   *
   * @param switchName the DEF name of the Switch
   */
  static List<String> lines(
      String switchName, List<String> inlineNames, List<String> urls, char quote, String step) {
    List<String> lines = new ArrayList<>();
    lines.add(
        "<Switch"
            + SourceFormatter.written("DEF", switchName, quote)
            + SourceFormatter.written("whichChoice", "0", quote)
            + ">");
    for (int i = 0; i < urls.size(); i++) {
      lines.add(step + inline(inlineNames.get(i), urls.get(i), quote));
    }
    lines.add("</Switch>");
    return lines;
  }

  /** Returns an Inline; its URL is in double quotes, so the attribute is in single quotes. */
  static String inline(String name, String url, char quote) {
    return "<Inline"
        + SourceFormatter.written("DEF", name, quote)
        + SourceFormatter.written("url", '"' + url + '"', '\'')
        + "/>";
  }

  /**
   * Returns the Inline of another version, written like the last one but without its children.
   *
   * @param tag start tag of the last Inline
   * @param name the new DEF name, used if the last Inline has one
   */
  static String further(String tag, int lastNumber, int number, String name) {
    // Only before the extension at the end of a URL: Car_v2_v2.x3d is numbered once.
    String turned =
        closed(tag)
            .replaceAll(
                "_v" + lastNumber + "(?=\\.[A-Za-z0-9]+(?:[\"'\\s#]|&quot;|&#))", "_v" + number);
    Matcher def = DEF.matcher(turned);
    return def.find()
        ? turned.substring(0, def.start())
            + SourceFormatter.written("DEF", name, def.group(1).charAt(0))
            + turned.substring(def.end())
        : turned;
  }

  private static String closed(String tag) {
    return tag.endsWith("/>") ? tag : tag.substring(0, tag.length() - 1) + "/>";
  }
}
