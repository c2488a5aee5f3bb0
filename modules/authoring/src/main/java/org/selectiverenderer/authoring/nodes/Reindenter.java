package org.selectiverenderer.authoring.nodes;

import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.SourceFormatter;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * Changes the indentation of an element's lines. Only lines that begin with a tag or a comment
 * change, so that attribute values and scripts keep every character.
 */
public final class Reindenter {
  private static final String PROGRAM = "<![CDATA[";

  private Reindenter() {}

  /** Indents all lines but the first. */
  public static String deeper(String element, String step) {
    return moved(element, step, true);
  }

  /** Unindents all lines but the first, if they are indented. */
  public static String shallower(String element, String step) {
    return moved(element, step, false);
  }

  /**
   * Returns the text of a node with an element around it, in the style of the document.
   *
   * @param open the start tag of the new element
   * @param close its end tag
   */
  public static String wrapped(
      SceneDocument document, DocumentElement node, String open, String close) {
    SourceFormatter layout = document.layout();
    if (!layout.onItsOwnLine(node)) {
      return open + document.text(node) + close;
    }
    String outer = layout.endOfLine(node) + layout.indentation(node);
    String step = layout.step(node);
    return open + outer + step + deeper(document.text(node), step) + outer + close;
  }

  private static String moved(String element, String step, boolean in) {
    StringBuilder text = new StringBuilder(element.length() + element.length() / 16);
    int programEnd = 0;
    int at = 0;
    while (at < element.length()) {
      int end = element.indexOf('\n', at);
      end = end < 0 ? element.length() : end + 1;
      int first = at;
      while (first < end && (element.charAt(first) == ' ' || element.charAt(first) == '\t')) {
        first++;
      }
      boolean tag = at > 0 && at >= programEnd && first < end && element.charAt(first) == '<';
      if (tag && in) {
        text.append(step).append(element, at, end);
      } else if (tag && element.startsWith(step, at)) {
        text.append(element, at + step.length(), end);
      } else {
        text.append(element, at, end);
      }
      int program = element.indexOf(PROGRAM, at);
      while (program >= 0 && program < end) {
        int close = element.indexOf("]]>", program);
        programEnd = close < 0 ? element.length() : close;
        program = element.indexOf(PROGRAM, programEnd);
      }
      at = end;
    }
    return text.toString();
  }
}
