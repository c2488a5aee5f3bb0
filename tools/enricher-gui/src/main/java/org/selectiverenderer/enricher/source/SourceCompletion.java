package org.selectiverenderer.enricher.source;

import java.awt.Component;
import java.awt.Point;
import java.awt.event.KeyAdapter;
import java.awt.event.KeyEvent;
import java.util.Optional;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JList;
import javax.swing.SwingUtilities;
import javax.swing.text.BadLocationException;
import javax.swing.text.Position;
import org.fife.ui.rsyntaxtextarea.RSyntaxTextArea;
import org.selectiverenderer.authoring.editing.CodeCompletion;
import org.selectiverenderer.authoring.editing.CompletionProposal;
import org.selectiverenderer.base.markup.MarkupEscaper;
import org.selectiverenderer.enricher.completion.CompletionPopup;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.swing.PlainText;

/**
 * Completion in the source view: proposes elements, fields and values at the caret on Ctrl+Space,
 * and after {@code <}.
 */
final class SourceCompletion {
  private final EnricherSession session;
  private final RSyntaxTextArea area;
  private final SourceAreaBinding page;
  private final CompletionPopup<CompletionProposal> list;
  private boolean asked;

  /** The closing quote of the attribute that was completed last. */
  private Optional<Position> closing = Optional.empty();

  SourceCompletion(EnricherSession session, RSyntaxTextArea area, SourceAreaBinding page) {
    this.session = session;
    this.area = area;
    this.page = page;
    list = new CompletionPopup<>(area, Texts.of("source.proposals"), this::take);
    list.renderer(new Row());
    area.addKeyListener(
        new KeyAdapter() {
          @Override
          public void keyPressed(KeyEvent event) {
            list.steer(event);
          }

          @Override
          public void keyTyped(KeyEvent event) {
            typeOverQuote(event);
            SwingUtilities.invokeLater(() -> follow(event)); // after it is inserted
          }
        });
  }

  /** Updates an open list after a key; opens one after {@code <}. */
  private void follow(KeyEvent event) {
    char typed = event.getKeyChar();
    boolean letter = Character.isLetterOrDigit(typed) || typed == '\b' || typed == '_';
    boolean controlled = event.isControlDown() || event.isMetaDown();
    if (controlled) {
      return;
    }
    if (typed == '<') {
      propose(false);
    } else if (list.open() && letter) {
      propose(asked);
    } else {
      list.close();
    }
  }

  /** Shows the proposals at the caret. */
  void propose() {
    propose(true);
  }

  private void propose(boolean wanted) {
    if (!area.isEditable()) {
      return;
    }
    asked = wanted;
    page.flush();
    int caret = page.inDocument(area.getCaretPosition());
    CodeCompletion.Proposals found =
        CodeCompletion.at(session.document().text(), caret, session.catalogue());
    if (found.proposals().isEmpty() && wanted) {
      session.message(Texts.of("source.noProposal"));
    }
    try {
      var at = area.modelToView2D(area.getCaretPosition()).getBounds();
      list.show(found.proposals(), new Point(at.x, at.y + at.height), true);
    } catch (BadLocationException e) {
      throw new IllegalStateException("the caret is outside of the text", e);
    }
  }

  private void take(CompletionProposal proposal) {
    page.flush();
    int caret = area.getCaretPosition();
    CodeCompletion.Proposals now =
        CodeCompletion.at(session.document().text(), page.inDocument(caret), session.catalogue());
    int from = page.inArea(now.from());
    area.replaceRange(proposal.text(), from, caret);
    int after = from + proposal.caret();
    area.setCaretPosition(after);
    if (proposal.caret() < proposal.text().length()) {
      try {
        closing = Optional.of(area.getDocument().createPosition(after));
      } catch (BadLocationException e) {
        throw new IllegalStateException("the completed text is not in the text", e);
      }
    }
  }

  /**
   * Moves the caret over the closing quote that a completion has written, when the author types
   * that quote behind the value.
   */
  private void typeOverQuote(KeyEvent event) {
    int caret = area.getCaretPosition();
    char typed = event.getKeyChar();
    if (typed != '\'' && typed != '"'
        || closing.filter(quote -> quote.getOffset() == caret).isEmpty()
        || area.getSelectionStart() != area.getSelectionEnd()) {
      return;
    }
    closing = Optional.empty();
    try {
      if (area.getText(caret, 1).charAt(0) == typed) {
        area.setCaretPosition(caret + 1);
        event.consume();
      }
    } catch (BadLocationException e) {
      return; // the caret is at the end of the text
    }
  }

  private static final class Row extends DefaultListCellRenderer {
    private static final long serialVersionUID = 1L;

    @Override
    public Component getListCellRendererComponent(
        JList<?> list, Object value, int index, boolean selected, boolean focused) {
      super.getListCellRendererComponent(
          list, PlainText.of(String.valueOf(value)), index, selected, focused);
      if (value instanceof CompletionProposal proposal && !proposal.about().isEmpty()) {
        setText(
            "<html>"
                + MarkupEscaper.text(proposal.word())
                + " &nbsp;<font color=gray>"
                + MarkupEscaper.text(proposal.about()));
        getAccessibleContext().setAccessibleName(proposal.word() + ", " + proposal.about());
      }
      return this;
    }
  }
}
