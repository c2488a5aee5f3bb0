package org.selectiverenderer.enricher.source;

import java.util.ArrayList;
import java.util.List;
import javax.swing.text.BadLocationException;
import org.fife.ui.rsyntaxtextarea.RSyntaxDocument;
import org.fife.ui.rsyntaxtextarea.RSyntaxTextArea;
import org.fife.ui.rsyntaxtextarea.SyntaxConstants;
import org.selectiverenderer.authoring.DocumentListener;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.x3d.source.TextEdit;

/**
 * Binds the text area to the part of the document that it shows: {@link #flush} writes what was
 * typed to the document, {@link #changed} shows other changes of the document. Offsets are those of
 * the document's text, unless a method says otherwise.
 */
final class SourceAreaBinding {
  /**
   * Most coloured characters of a text with code folding, for which all tags are parsed after each
   * pause.
   */
  private static final int FOLDED = 400_000;

  private final EnricherSession session;
  private final RSyntaxTextArea area;
  private final LongLineTokenMaker tokens = new LongLineTokenMaker();
  private final List<Runnable> listeners = new ArrayList<>();
  private VisibleSourceRange page = new VisibleSourceRange(0, 0, false);
  private NormalizedText text = NormalizedText.of("");
  private boolean following;

  SourceAreaBinding(EnricherSession session, RSyntaxTextArea area) {
    this.session = session;
    this.area = area;
    area.setSyntaxEditingStyle(SyntaxConstants.SYNTAX_STYLE_XML);
    ((RSyntaxDocument) area.getDocument()).setSyntaxStyle(tokens);
  }

  /** Adds a listener that runs when another part is shown, or the part has grown or moved. */
  void onShown(Runnable listener) {
    listeners.add(listener);
  }

  private SceneDocument document() {
    return session.document();
  }

  VisibleSourceRange shown() {
    return page;
  }

  /** Whether the program, not the author, is changing the area or moving its caret. */
  boolean following() {
    return following;
  }

  boolean holds(int offset) {
    return page.holds(offset);
  }

  /** Converts an offset to one in the area; clamps it to the shown part. */
  int inArea(int offset) {
    int within = Math.max(page.from(), Math.min(offset, page.to()));
    return Math.min(text.inShown(within - page.from()), area.getDocument().getLength());
  }

  /**
   * Converts an offset in the area to one in the document; what was typed must be flushed before.
   */
  int inDocument(int offset) {
    return page.from() + text.inFile(offset);
  }

  /** Shows the part of the text around an offset, with nothing selected. */
  void turn(int offset) {
    flush();
    load(VisibleSourceRange.around(document().text(), offset));
  }

  private void load(VisibleSourceRange next) {
    quietly(
        () -> {
          page = next;
          text = NormalizedText.of(document().text(next.from(), next.to()));
          tokens.beginWithinLine(next.withinLine());
          area.setCodeFoldingEnabled(LongLineTokenMaker.colored(text.shown()) <= FOLDED);
          area.setText(text.shown());
          area.setCaretPosition(0);
          area.discardAllEdits();
        });
    listeners.forEach(Runnable::run);
  }

  /** Changes the area without treating the change as typing. */
  private void quietly(Runnable change) {
    boolean before = following;
    following = true;
    try {
      change.run();
    } finally {
      following = before;
    }
  }

  /** Writes what was typed since the last flush to the document. */
  void flush() {
    if (following) {
      return;
    }
    String now = area.getText();
    if (now.equals(text.shown())) {
      return;
    }
    TextEdit local = text.change(now);
    int from = page.from() + local.from();
    int to = page.from() + local.to();
    quietly(
        () -> {
          if (!session.attempt(() -> document().type(from, to, local.text()))) {
            load(page);
          }
        });
  }

  /** Shows a change of the document. */
  void changed(DocumentListener.Change change) {
    int from = page.from();
    int to = page.to();
    boolean inside = true;
    for (int i = change.changes().size() - 1; i >= 0; i--) {
      TextEdit each = change.changes().get(i);
      if (each.from() >= from && each.to() <= to) {
        to += each.growth();
      } else if (each.to() <= from) {
        from += each.growth();
        to += each.growth();
      } else if (each.from() < to) {
        inside = false;
      }
    }
    int length = document().text().length();
    if (inside && to <= length) {
      update(new VisibleSourceRange(from, to, page.withinLine()));
    } else {
      load(VisibleSourceRange.around(document().text(), Math.min(page.from(), length)));
    }
  }

  /** Replaces only what differs, so that caret and scroll position stay. */
  private void update(VisibleSourceRange next) {
    quietly(
        () -> {
          page = next;
          String shown = area.getText();
          NormalizedText now = NormalizedText.of(document().text(next.from(), next.to()));
          text = now;
          if (!shown.equals(now.shown())) {
            replaceWhatDiffers(shown, now.shown());
          }
        });
    listeners.forEach(Runnable::run);
  }

  private void replaceWhatDiffers(String shown, String now) {
    TextEdit change = new NormalizedText(shown, shown).change(now);
    try {
      area.getDocument().remove(change.from(), change.to() - change.from());
      area.getDocument().insertString(change.from(), change.text(), null);
    } catch (BadLocationException e) {
      throw new IllegalStateException("the source view is not what the document says", e);
    }
  }

  /** Scrolls to an offset and puts the caret there. */
  void reveal(int offset) {
    select(offset, offset);
  }

  /** Scrolls to a range and selects it, as far as it is in the shown part. */
  void select(int from, int to) {
    flush();
    if (!holds(from) || !holds(Math.min(to, from + VisibleSourceRange.PAGE / 2))) {
      turn(from);
    }
    quietly(
        () -> {
          int start = inArea(from);
          int end = inArea(to);
          area.getFoldManager().ensureOffsetNotInClosedFold(start);
          area.setCaretPosition(start);
          area.moveCaretPosition(end);
          scrollTo(start);
        });
  }

  private void scrollTo(int offset) {
    try {
      var shown = area.modelToView2D(offset);
      if (shown != null) {
        var target = shown.getBounds();
        target.grow(0, area.getVisibleRect().height / 3);
        target.x = 0;
        area.scrollRectToVisible(target);
        target = shown.getBounds();
        area.scrollRectToVisible(target);
      }
    } catch (BadLocationException e) {
      throw new IllegalStateException("the caret is outside of the text", e);
    }
  }
}
