package org.selectiverenderer.document.versions;

import java.util.List;
import org.selectiverenderer.document.Snapshot;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.TextChange;

/**
 * Formats a Switch that replaces an element that shares its line with others: the Switch begins
 * where the element began and continues on lines of its own, so that the versions can be read.
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

  /** Returns one step of indentation. */
  String step() {
    return indentation.contains("\t") ? "\t" : "  ";
  }

  /** Returns the quote character that the scene uses first. */
  char quote() {
    int single = text.indexOf("='");
    int twice = text.indexOf("=\"", Math.max(0, text.indexOf("?>")));
    return single < 0 || twice >= 0 && twice < single ? '"' : '\'';
  }

  /** Replaces the element by lines. */
  TextChange replace(List<String> lines) {
    String separator = endOfLine() + indentation;
    return new TextChange(element.start(), element.end(), String.join(separator, lines));
  }

  /** Returns the line end of the scene's first line. */
  private String endOfLine() {
    int feed = text.indexOf('\n');
    if (feed < 0) {
      return text.indexOf('\r') < 0 ? "\n" : "\r";
    }
    return feed > 0 && text.charAt(feed - 1) == '\r' ? "\r\n" : "\n";
  }
}
