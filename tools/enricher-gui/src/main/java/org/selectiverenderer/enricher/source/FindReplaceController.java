package org.selectiverenderer.enricher.source;

import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import org.fife.ui.rsyntaxtextarea.RSyntaxTextArea;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.authoring.DocumentListener;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.editing.TextSearch;
import org.selectiverenderer.authoring.editing.TextSearch.BadSearch;
import org.selectiverenderer.authoring.editing.TextSearch.Hit;
import org.selectiverenderer.authoring.editing.TextSearch.Wanted;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.x3d.source.TextEdit;

/**
 * Finds and replaces for the find bar: searches the whole document, whatever part of it is shown,
 * steps from hit to hit, wrapping at both ends, and replaces.
 */
final class FindReplaceController {
  private final EnricherSession session;
  private final RSyntaxTextArea area;
  private final SourceAreaBinding page;
  private final SourceHighlighter marks;
  private Consumer<Found> listener = found -> {};
  private @Nullable TextSearch search;
  private @Nullable Wanted last;
  private List<Hit> hits = List.of();
  private long revision = -1;
  private String complaint = "";

  /** The range to search; null for the whole text. */
  private @Nullable Hit scope;

  /**
   * The result of a search, as the bar shows it.
   *
   * @param now number of the selected hit, from 1; 0 for none
   * @param wrapped whether it was reached by wrapping around an end of the text
   * @param complaint why the search is invalid; empty if it is valid
   */
  record Found(int count, int now, boolean wrapped, String complaint) {}

  FindReplaceController(
      EnricherSession session,
      RSyntaxTextArea area,
      SourceAreaBinding page,
      SourceHighlighter marks) {
    this.session = session;
    this.area = area;
    this.page = page;
    this.marks = marks;
    page.onShown(this::mark);
  }

  void onFound(Consumer<Found> hears) {
    listener = hears;
  }

  /** Limits the search to the present selection, or to the whole text. */
  void within(boolean selection) {
    page.flush();
    int from = page.inDocument(area.getSelectionStart());
    int to = page.inDocument(area.getSelectionEnd());
    scope = selection && from < to ? new Hit(from, to) : null;
    last = null;
  }

  /** Adapts the range to a change of the text. */
  void changed(DocumentListener.Change change) {
    Hit before = scope;
    if (before == null) {
      return;
    }
    int from = before.from();
    int to = before.to();
    for (int i = change.changes().size() - 1; i >= 0; i--) {
      TextEdit each = change.changes().get(i);
      if (each.to() <= from && each.from() < from) {
        from += each.growth();
        to += each.growth();
      } else if (each.from() <= to) {
        to = Math.max(from, to + each.growth());
      }
    }
    scope = new Hit(from, Math.min(to, session.document().text().length()));
  }

  /** Ends the search. */
  void end() {
    hits = List.of();
    last = null;
    scope = null;
    marks.hits(List.of());
    area.requestFocusInWindow();
  }

  /** Finds all hits, unless neither search nor text has changed. */
  void search(Wanted wanted) {
    page.flush();
    long now = session.document().revision();
    if (wanted.equals(last) && now == revision) {
      return;
    }
    last = wanted;
    revision = now;
    complaint = "";
    search = null;
    hits = List.of();
    if (!wanted.words().isEmpty()) {
      CharSequence text = session.document().text();
      Hit range = scope == null ? new Hit(0, text.length()) : scope;
      try {
        search = TextSearch.of(wanted);
        hits = search.all(text, range.from(), range.to());
      } catch (BadSearch e) {
        complaint = String.valueOf(e.getMessage());
      }
    }
    mark();
    tell(false);
  }

  private void mark() {
    marks.hits(hits);
  }

  /** The index of the first hit at or after an offset. */
  private int from(int offset) {
    int low = 0;
    int high = hits.size();
    while (low < high) {
      int middle = (low + high) >>> 1;
      if (hits.get(middle).from() < offset) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low;
  }

  /** The index of the selected hit; -1 for none. */
  private int selected() {
    int start = page.inDocument(area.getSelectionStart());
    int end = page.inDocument(area.getSelectionEnd());
    int at = from(start);
    boolean here = at < hits.size() && hits.get(at).equals(new Hit(start, end));
    return here ? at : -1;
  }

  private void tell(boolean wrapped) {
    int now = hits.isEmpty() ? 0 : selected() + 1;
    listener.accept(new Found(hits.size(), now, wrapped, complaint));
  }

  /** Selects the next or previous hit. */
  void step(int by) {
    if (hits.isEmpty()) {
      return;
    }
    int now = selected();
    int caret = page.inDocument(area.getSelectionStart());
    int next = now >= 0 ? now + by : by > 0 ? from(caret) : from(caret) - 1;
    boolean wrapped = next < 0 || next >= hits.size();
    show(Math.floorMod(next, hits.size()), wrapped);
  }

  /** Selects the first hit at or after the caret, while the search text is typed. */
  void stepToNearest() {
    if (!hits.isEmpty()) {
      int next = from(page.inDocument(area.getSelectionStart()));
      show(next % hits.size(), next >= hits.size());
    }
  }

  private void show(int index, boolean wrapped) {
    Hit hit = hits.get(index);
    page.select(hit.from(), hit.to());
    tell(wrapped);
  }

  /** Replaces the selected hit and selects the next; only selects one if none is selected. */
  void replaceOne(String replacement) {
    int now = selected();
    if (now < 0 || search == null || last == null) {
      step(1);
      return;
    }
    Hit hit = hits.get(now);
    Wanted wanted = last;
    TextSearch found = search;
    make(
        () ->
            found.replace(
                session.document().text(),
                hit,
                replacement,
                Texts.of("source.replaceStep", wanted.words())));
    search(wanted);
    int next = hits.isEmpty() ? 0 : from(hit.from() + replacement.length());
    if (!hits.isEmpty()) {
      show(next % hits.size(), next >= hits.size());
    }
  }

  /** Replaces all hits as one undo step. */
  void replaceAll(String replacement) {
    if (search == null || last == null) {
      return;
    }
    int count = hits.size();
    Wanted wanted = last;
    TextSearch found = search;
    CharSequence text = session.document().text();
    Hit range = scope == null ? new Hit(0, text.length()) : scope;
    boolean made =
        make(
            () ->
                found.replaceAll(
                    text,
                    range.from(),
                    range.to(),
                    replacement,
                    Texts.of("source.replaceAllStep", wanted.words())));
    if (made) {
      session.message(Texts.of("source.replaced", count, String.format(Locale.ROOT, "%,d", count)));
      search(wanted);
    }
  }

  private interface Making {
    Edit edit() throws BadSearch;
  }

  private boolean make(Making making) {
    try {
      session.perform(making.edit());
      return true;
    } catch (BadSearch e) {
      session.message(String.valueOf(e.getMessage()));
      return false;
    }
  }
}
