package org.selectiverenderer.enricher.source;

import java.awt.Color;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.text.BadLocationException;
import org.fife.ui.rsyntaxtextarea.RSyntaxTextArea;
import org.fife.ui.rtextarea.SmartHighlightPainter;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.editing.TagMatcher;
import org.selectiverenderer.authoring.editing.TextSearch.Hit;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * Highlights in the text: both tags of the selected element, the line of a fault, and search hits.
 */
final class SourceHighlighter {
  /** Most hits that are highlighted in one part of the text. */
  private static final int HITS = 2000;

  private final RSyntaxTextArea area;
  private final SourceAreaBinding page;
  private final List<Object> tags = new ArrayList<>();
  private final List<Object> hits = new ArrayList<>();
  private @Nullable Object faultLine;

  SourceHighlighter(RSyntaxTextArea area, SourceAreaBinding page) {
    this.area = area;
    this.page = page;
  }

  /** Highlights the start tag of an element and, where it has one, its end tag. */
  void element(SceneDocument document, Optional<DocumentElement> element) {
    clear(tags);
    if (element.isEmpty() || !element.get().attached()) {
      return;
    }
    DocumentElement marked = element.get();
    mark(tags, marked.start(), marked.tagEnd(), SourceStyle.elementTag());
    if (marked.open()) {
      int end = TagMatcher.endTag(document.text(), marked);
      mark(tags, end, marked.end(), SourceStyle.elementTag());
    }
  }

  /** Highlights search hits, which are in order. */
  void hits(List<Hit> found) {
    clear(hits);
    for (Hit hit : found) {
      if (hit.from() > page.shown().to() || hits.size() >= HITS) {
        return;
      }
      if (hit.to() >= page.shown().from()) {
        mark(hits, hit.from(), hit.to(), SourceStyle.hit());
      }
    }
  }

  private void mark(List<Object> marks, int from, int to, Color color) {
    boolean visible = from < page.shown().to() && to > page.shown().from() && from < to;
    try {
      if (visible) {
        marks.add(
            area.getHighlighter()
                .addHighlight(
                    page.inArea(from), page.inArea(to), new SmartHighlightPainter(color)));
      }
    } catch (BadLocationException e) {
      throw new IllegalStateException("a mark is outside of the text", e);
    }
  }

  private void clear(List<Object> marks) {
    marks.forEach(area.getHighlighter()::removeHighlight);
    marks.clear();
  }

  /** Highlights the line where the text stops being well formed. */
  void fault(SceneDocument document) {
    if (faultLine != null) {
      area.removeLineHighlight(faultLine);
      faultLine = null;
    }
    Optional<Integer> offset =
        document
            .fault()
            .map(fault -> fault.location())
            .map(at -> document.offset(Math.max(1, at.line()), Math.max(1, at.column())));
    try {
      if (offset.isPresent() && page.holds(offset.get())) {
        int line = area.getLineOfOffset(page.inArea(offset.get()));
        faultLine = area.addLineHighlight(line, SourceStyle.errorLine());
      }
    } catch (BadLocationException e) {
      faultLine = null; // the text ends before the fault
    }
  }
}
