package org.selectiverenderer.enricher.source;

import java.beans.PropertyChangeListener;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
import javax.swing.Timer;
import javax.swing.UIManager;
import javax.swing.text.BadLocationException;
import net.miginfocom.swing.MigLayout;
import org.fife.ui.rsyntaxtextarea.RSyntaxTextArea;
import org.fife.ui.rtextarea.RTextScrollPane;
import org.selectiverenderer.authoring.DocumentListener;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.editing.CommentToggle;
import org.selectiverenderer.authoring.editing.TagMatcher;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.enricher.component.InputDialog;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.session.SelectionListener;
import org.selectiverenderer.enricher.text.MnemonicText;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * The source view: an editor for the text of the scene. What is typed reaches the document after a
 * short pause, or at once by {@link #flush}; a text too large for a text component is shown a page
 * at a time.
 */
public final class SourcePanel {
  private static final int REACH_MILLISECONDS = 300;
  private static final int PAUSE_MILLISECONDS = 1200;

  private final EnricherSession session;
  private final RSyntaxTextArea area = new RSyntaxTextArea();
  private final RTextScrollPane scroll = new RTextScrollPane(area);
  private final SourceAreaBinding page;
  private final SourceHighlighter marks;
  private final TypingUndoGrouper steps;
  private final SourceCompletion completion;
  private final FindReplaceController finding;
  private final FindBar find;
  private final FaultBar fault = new FaultBar(this::showFault);
  private final PageBar pages;
  private final JPanel panel =
      new JPanel(new MigLayout("insets 0, gap 0, fill, hidemode 2", "[grow]", "[grow][][][]"));
  private final SelectionListener selecting = this::follow;
  private final DocumentListener changing = this::changed;
  private final PropertyChangeListener restyling = event -> restyle();

  /** Whether another part is to be shown as soon as the panel is, as its element is selected. */
  private boolean behind;

  private final Timer moved = new Timer(REACH_MILLISECONDS, event -> caretMoved());

  public SourcePanel(EnricherSession session) {
    this.session = session;
    moved.setRepeats(false);
    SourceAreaSetup.apply(area, scroll);
    area.setEditable(document().locked().isEmpty());
    page = new SourceAreaBinding(session, area);
    marks = new SourceHighlighter(area, page);
    steps =
        new TypingUndoGrouper(
            area, page, document().history(), REACH_MILLISECONDS, PAUSE_MILLISECONDS);
    completion = new SourceCompletion(session, area, page);
    finding = new FindReplaceController(session, area, page, marks);
    find = new FindBar(finding);
    pages = new PageBar(page);
    page.onShown(this::number);
    panel.add(scroll, "grow, wmin 0, hmin 0, wrap");
    // Below the text, which thus does not move while a tag is half typed.
    panel.add(fault.component(), "growx, wrap");
    panel.add(find.component(), "growx, wmin 0, wrap");
    panel.add(pages.component(), "growx");
    area.addCaretListener(
        event -> {
          if (!page.following()) {
            moved.restart();
          }
        });
    SourceAreaSetup.key(area, "ctrl SPACE", completion::propose);
    panel.addHierarchyListener(event -> catchUp());
    UIManager.addPropertyChangeListener(restyling);
    session.addSelectionListener(selecting);
    session.document().addListener(changing);
    page.turn(0);
    SourceStyle.apply(area, scroll);
    showNotice();
  }

  public JComponent component() {
    return panel;
  }

  public RSyntaxTextArea area() {
    return area;
  }

  private SceneDocument document() {
    return session.document();
  }

  private void restyle() {
    SourceStyle.apply(area, scroll);
    showNotice();
    follow(session.selection(), session);
  }

  private void number() {
    int first = document().location(page.shown().from()).line();
    scroll.getGutter().setLineNumberingStartIndex(first);
    pages.show(page.shown(), document().text().length());
    showNotice();
    marks.element(document(), session.selection());
  }

  /** Writes what was typed since the last flush to the document. */
  public void flush() {
    page.flush();
  }

  /** Flushes and ends the undo step, so that what is typed next is a step of its own. */
  public void endStep() {
    steps.end();
  }

  private void changed(DocumentListener.Change change) {
    finding.changed(change);
    page.changed(change);
    showNotice();
    marks.element(document(), session.selection());
  }

  private void showNotice() {
    fault.show(document());
    marks.fault(document());
  }

  /** Scrolls to the place where the text stops being well formed. */
  public void showFault() {
    document()
        .fault()
        .ifPresent(
            found -> {
              SourceLocation at = found.location();
              reveal(document().offset(Math.max(1, at.line()), Math.max(1, at.column())));
            });
  }

  /** Scrolls to an offset and puts the caret there. */
  public void reveal(int offset) {
    steps.end();
    page.reveal(offset);
  }

  private int caret() {
    page.flush();
    return page.inDocument(area.getCaretPosition());
  }

  private void caretMoved() {
    int offset = caret();
    document()
        .tree()
        .flatMap(tree -> tree.at(offset))
        .ifPresent(element -> session.select(element, this));
    marks.element(document(), session.selection());
  }

  private void follow(Optional<DocumentElement> element, Object origin) {
    boolean typingHere = origin == session && area.isFocusOwner();
    behind = !panel.isShowing() && page.shown().length() < document().text().length();
    if (behind) {
      return;
    }
    if (origin != this && !typingHere && !page.following()) {
      element.filter(DocumentElement::attached).ifPresent(each -> reveal(each.start()));
    }
    marks.element(document(), element);
  }

  private void catchUp() {
    if (behind && panel.isShowing()) {
      follow(session.selection(), session);
    }
  }

  /** Opens the find bar, with or without the line for replacing. */
  public void find(boolean replace) {
    steps.end();
    String selected = Optional.ofNullable(area.getSelectedText()).orElse("");
    find.open(replace, selected);
  }

  /** Goes to the next or previous hit of the last search. */
  public void findNext(int by) {
    steps.end();
    find.step(by);
  }

  /** Asks for a line and goes there. */
  public void goToLine() {
    int now = document().location(caret()).line();
    InputDialog.ask(
            panel,
            MnemonicText.of(Texts.of("source.menuLine")).words(),
            Texts.of("source.lineQuestion"),
            Integer.toString(now),
            answer ->
                line(answer).isPresent()
                    ? Optional.empty()
                    : Optional.of(Texts.of("source.noLine", answer)))
        .flatMap(SourcePanel::line)
        .ifPresent(this::goToLine);
  }

  private static Optional<Integer> line(String answer) {
    try {
      return Optional.of(Integer.valueOf(answer));
    } catch (NumberFormatException e) {
      return Optional.empty();
    }
  }

  void goToLine(int line) {
    int last = document().location(document().text().length()).line();
    reveal(document().offset(Math.max(1, Math.min(line, last)), 1));
    area.requestFocusInWindow();
  }

  /** Puts the caret on the matching tag of the element that it is in. */
  public void goToMatchingTag() {
    int caret = caret();
    document()
        .tree()
        .flatMap(tree -> TagMatcher.partner(document().text(), tree, caret))
        .ifPresentOrElse(this::reveal, () -> session.message(Texts.of("source.noMatchingTag")));
  }

  /** Comments out the selection or the line, or removes the comment around it. */
  public void toggleComment() {
    steps.end();
    try {
      int line = area.getLineOfOffset(area.getCaretPosition());
      boolean some = area.getSelectionStart() < area.getSelectionEnd();
      int start = some ? area.getSelectionStart() : area.getLineStartOffset(line);
      int end = some ? area.getSelectionEnd() : area.getLineEndOffset(line);
      int from = page.inDocument(start);
      int to = page.inDocument(end);
      session.attempt(
          () ->
              document()
                  .perform(
                      CommentToggle.toggle(
                          document().text(), from, to, Texts.of("source.commentStep"))));
    } catch (BadLocationException e) {
      throw new IllegalStateException("the caret is outside of the text", e);
    }
  }

  /**
   * Sets the context menu: the text's commands, and below them those for the element at the caret.
   *
   * @param node appends the commands for the element
   */
  public void onMenu(Consumer<JPopupMenu> node) {
    area.setPopupMenu(
        new SourceContextMenu(
            area,
            () -> {
              moved.stop();
              caretMoved();
            },
            node));
  }

  /** Stops following the session. */
  public void dispose() {
    steps.stop();
    moved.stop();
    UIManager.removePropertyChangeListener(restyling);
    session.removeSelectionListener(selecting);
    session.document().removeListener(changing);
  }
}
