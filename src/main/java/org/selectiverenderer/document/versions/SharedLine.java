package org.selectiverenderer.document.versions;

import java.util.List;
import org.selectiverenderer.document.Snapshot;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.TextChange;

/**
 * Lays out a Switch in place of an element that shares its line with others: it begins where that
 * began, and has lines of its own below, so that a version can be found in it.
 */
final class SharedLine {
  private final String text;
  private final DocumentElement element;
  private final String indentation;

  SharedLine(Snapshot scene, DocumentElement element) {
    this.text = scene.text();
    this.element = element;
    this.indentation = scene.layout().indentation(element);
  }

  /** One step of indentation. */
  String step() {
    return indentation.contains("\t") ? "\t" : "  ";
  }

  /** The quote that the scene uses first. */
  char quote() {
    int single = text.indexOf("='");
    int twice = text.indexOf("=\"", Math.max(0, text.indexOf("?>")));
    return single < 0 || twice >= 0 && twice < single ? '"' : '\'';
  }

  /** Puts lines in the element's place. */
  TextChange replace(List<String> lines) {
    String separator = endOfLine() + indentation;
    return new TextChange(element.start(), element.end(), String.join(separator, lines));
  }

  /** What ends the scene's first line. */
  private String endOfLine() {
    int feed = text.indexOf('\n');
    if (feed < 0) {
      return text.indexOf('\r') < 0 ? "\n" : "\r";
    }
    return feed > 0 && text.charAt(feed - 1) == '\r' ? "\r\n" : "\n";
  }
}
