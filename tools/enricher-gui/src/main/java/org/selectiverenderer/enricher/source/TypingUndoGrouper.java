package org.selectiverenderer.enricher.source;

import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import javax.swing.Timer;
import javax.swing.event.DocumentEvent;
import javax.swing.event.DocumentListener;
import org.fife.ui.rsyntaxtextarea.RSyntaxTextArea;
import org.selectiverenderer.authoring.UndoHistory;

/**
 * Groups typing into undo steps and writes it to the document after a short delay. A step ends at a
 * pause, at the end of a line, when the caret moves elsewhere, and on focus loss.
 */
final class TypingUndoGrouper {
  private final SourceAreaBinding page;
  private final UndoHistory history;
  private final Timer reaching;
  private final Timer ending;
  private int expected = -1;
  private boolean newLine;

  /**
   * @param reach milliseconds without a key after which typing is written to the document
   * @param pause milliseconds without a key after which the undo step ends
   */
  TypingUndoGrouper(
      RSyntaxTextArea area, SourceAreaBinding page, UndoHistory history, int reach, int pause) {
    this.page = page;
    this.history = history;
    this.reaching = once(reach, page::flush);
    this.ending = once(pause, this::end);
    area.getDocument().addDocumentListener(new Typing());
    area.addCaretListener(event -> moved(event.getDot()));
    area.addFocusListener(
        new FocusAdapter() {
          @Override
          public void focusLost(FocusEvent e) {
            end();
          }
        });
  }

  private static Timer once(int milliseconds, Runnable work) {
    Timer timer = new Timer(milliseconds, event -> work.run());
    timer.setRepeats(false);
    return timer;
  }

  private final class Typing implements DocumentListener {
    @Override
    public void insertUpdate(DocumentEvent e) {
      typed(e.getOffset() + e.getLength());
      newLine |= !page.following() && endsLine(e);
    }

    @Override
    public void removeUpdate(DocumentEvent e) {
      typed(e.getOffset());
    }

    @Override
    public void changedUpdate(DocumentEvent e) {
      // styles only
    }

    private boolean endsLine(DocumentEvent e) {
      int lines = e.getDocument().getDefaultRootElement().getElementIndex(e.getOffset());
      int after =
          e.getDocument().getDefaultRootElement().getElementIndex(e.getOffset() + e.getLength());
      return after > lines;
    }
  }

  private void typed(int caret) {
    if (!page.following()) {
      expected = caret;
      reaching.restart();
      ending.restart();
    }
  }

  /** Ends the step when the caret moves to anywhere but the end of what was typed. */
  private void moved(int caret) {
    if (page.following()) {
      return;
    }
    if (caret != expected || newLine) {
      end();
    }
  }

  /** Writes what was typed to the document and ends the undo step. */
  void end() {
    newLine = false;
    stop();
    page.flush();
    history.endTyping();
  }

  void stop() {
    reaching.stop();
    ending.stop();
  }
}
