package org.selectiverenderer.enricher.source;

import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.beans.PropertyChangeListener;
import java.util.List;
import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import javax.swing.Timer;
import javax.swing.UIManager;
import javax.swing.event.DocumentEvent;
import javax.swing.event.DocumentListener;
import javax.swing.text.BadLocationException;
import net.miginfocom.swing.MigLayout;
import org.fife.ui.rsyntaxtextarea.RSyntaxTextArea;
import org.fife.ui.rsyntaxtextarea.SyntaxConstants;
import org.fife.ui.rtextarea.RTextScrollPane;
import org.fife.ui.rtextarea.SmartHighlightPainter;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.markup.Markup;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.document.SceneDocument;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.session.SelectionListener;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.DocumentFault;
import org.selectiverenderer.x3d.source.TextChange;

/**
 * The text of the scene. What is typed reaches the document after a short pause, or at once by
 * {@link #flush}; a text too big for a text component is shown a page at a time.
 */
public final class SourcePanel {
  private static final int PAUSE_MILLISECONDS = 300;

  private final EnricherSession session;
  private final RSyntaxTextArea area = new RSyntaxTextArea();
  private final RTextScrollPane scroll = new RTextScrollPane(area);
  private final JLabel notice = new JLabel();
  private final JButton place = new JButton("Show");
  private final JLabel pageText = new JLabel();
  private final JPanel pages = new JPanel(new MigLayout("insets 4 6 4 6", "[][][grow]"));
  private final JPanel strip = new JPanel(new MigLayout("insets 6", "[grow][]"));
  private final JPanel panel =
      new JPanel(new MigLayout("insets 0, gap 0, fill, hidemode 3", "[grow]", "[][grow][]"));
  private final SelectionListener selecting = this::follow;
  private final org.selectiverenderer.document.DocumentListener changing = this::changed;
  private final PropertyChangeListener restyling;
  private final Timer typed = once(this::flush);
  private final Timer moved = once(this::caretMoved);
  private SourcePage page = new SourcePage(0, 0, false);
  private ShownText text = ShownText.of("");
  private boolean following;
  private @Nullable Object faultLine;
  private @Nullable Object tagMark;

  public SourcePanel(EnricherSession session) {
    this.session = session;
    area.setCodeFoldingEnabled(false);
    area.setAntiAliasingEnabled(true);
    for (String key : List.of("ctrl Z", "ctrl Y", "ctrl shift Z", "ctrl shift F")) {
      area.getInputMap().put(KeyStroke.getKeyStroke(key), "none"); // the window's
    }
    area.setMarkOccurrences(false);
    area.setTabSize(2);
    area.setHighlightCurrentLine(true);
    area.setEditable(session.document().locked().isEmpty());
    area.getAccessibleContext().setAccessibleName("Source of the scene");
    scroll.getVerticalScrollBar().getAccessibleContext().setAccessibleName("Scroll the source");
    scroll.getHorizontalScrollBar().getAccessibleContext().setAccessibleName("Scroll the source");
    notice.getAccessibleContext().setAccessibleName("State of the source");
    strip.add(notice, "growx, wmin 0");
    strip.add(place);
    place.addActionListener(event -> showFault());
    JButton earlier = new JButton("Earlier part");
    JButton later = new JButton("Later part");
    earlier.addActionListener(event -> turn(Math.max(0, page.from() - SourcePage.PAGE / 2)));
    later.addActionListener(event -> turn(page.to() + SourcePage.PAGE / 4));
    pages.add(earlier);
    pages.add(later);
    pages.add(pageText, "growx, wmin 0");
    panel.add(strip, "growx, wrap");
    panel.add(scroll, "grow, wmin 0, hmin 0, wrap");
    panel.add(pages, "growx");
    area.getDocument().addDocumentListener(new Typing());
    area.addCaretListener(
        event -> {
          if (!following) {
            moved.restart();
          }
        });
    area.addFocusListener(
        new FocusAdapter() {
          @Override
          public void focusLost(FocusEvent e) {
            flush();
          }
        });
    restyling = event -> restyle();
    UIManager.addPropertyChangeListener(restyling);
    session.addSelectionListener(selecting);
    session.document().addListener(changing);
    load(SourcePage.around(session.document().text(), 0));
    SourceStyle.apply(area, scroll);
    showNotice();
  }

  private static Timer once(Runnable work) {
    Timer timer = new Timer(PAUSE_MILLISECONDS, event -> work.run());
    timer.setRepeats(false);
    return timer;
  }

  private final class Typing implements DocumentListener {
    @Override
    public void insertUpdate(DocumentEvent e) {
      heard();
    }

    @Override
    public void removeUpdate(DocumentEvent e) {
      heard();
    }

    @Override
    public void changedUpdate(DocumentEvent e) {
      // styles only
    }

    private void heard() {
      if (!following) {
        typed.restart();
      }
    }
  }

  public JPanel component() {
    return panel;
  }

  public RSyntaxTextArea area() {
    return area;
  }

  private void restyle() {
    SourceStyle.apply(area, scroll);
    showNotice();
    follow(session.selection(), session);
  }

  private SceneDocument document() {
    return session.document();
  }

  private void load(SourcePage next) {
    boolean before = following;
    following = true;
    try {
      page = next;
      text = ShownText.of(document().text(next.from(), next.to()));
      area.setSyntaxEditingStyle(
          next.plain() ? SyntaxConstants.SYNTAX_STYLE_NONE : SyntaxConstants.SYNTAX_STYLE_XML);
      tagMark = null;
      faultLine = null;
      area.setText(text.shown());
      area.setCaretPosition(0);
      area.discardAllEdits();
      number();
    } finally {
      following = before;
    }
  }

  private void number() {
    int first = document().location(page.from()).line();
    scroll.getGutter().setLineNumberingStartIndex(first);
    int all = document().text().length();
    pages.setVisible(page.length() < all);
    pageText.setText(
        "The scene is large: characters %,d to %,d of %,d are shown"
            .formatted(page.from(), page.to(), all));
  }

  private void turn(int offset) {
    flush();
    load(SourcePage.around(document().text(), offset));
    showNotice();
  }

  /** Gives the document what was typed and has not reached it yet. */
  public void flush() {
    typed.stop();
    String now = area.getText();
    if (following || now.equals(text.shown())) {
      return;
    }
    TextChange local = text.change(now);
    TextChange change =
        new TextChange(page.from() + local.from(), page.from() + local.to(), local.text());
    following = true;
    try {
      if (!session.attempt(() -> document().type(change.from(), change.to(), change.text()))) {
        load(page);
      }
    } finally {
      following = false;
    }
  }

  private void changed(org.selectiverenderer.document.DocumentListener.Change change) {
    int from = page.from();
    int to = page.to();
    boolean inside = true;
    for (int i = change.changes().size() - 1; i >= 0; i--) {
      TextChange each = change.changes().get(i);
      int growth = each.text().length() - (each.to() - each.from());
      if (each.from() >= from && each.to() <= to) {
        to += growth;
      } else if (each.to() <= from) {
        from += growth;
        to += growth;
      } else if (each.from() < to) {
        inside = false;
      }
    }
    int length = document().text().length();
    if (inside && to <= length) {
      update(new SourcePage(from, to, page.plain()));
    } else {
      load(SourcePage.around(document().text(), Math.min(page.from(), length)));
    }
    showNotice();
    mark(session.selection());
  }

  /** Replaces only what differs, so that caret and scroll position stay. */
  private void update(SourcePage next) {
    boolean before = following;
    following = true;
    try {
      page = next;
      String shown = area.getText();
      ShownText now = ShownText.of(document().text(next.from(), next.to()));
      text = now;
      if (!shown.equals(now.shown())) {
        TextChange change = new ShownText(shown, shown).change(now.shown());
        area.getDocument().remove(change.from(), change.to() - change.from());
        area.getDocument().insertString(change.from(), change.text(), null);
      }
      number();
    } catch (BadLocationException e) {
      throw new IllegalStateException("the source view is not what the document says", e);
    } finally {
      following = before;
    }
  }

  private void showNotice() {
    Optional<DocumentFault> fault = document().fault();
    Optional<String> locked = document().locked();
    strip.setVisible(fault.isPresent() || locked.isPresent());
    place.setVisible(fault.isPresent());
    if (faultLine != null) {
      area.removeLineHighlight(faultLine);
      faultLine = null;
    }
    notice.setIcon(UIManager.getIcon("OptionPane.warningIcon"));
    if (fault.isPresent()) {
      Location at = fault.get().location();
      notice.setText(
          "<html><b>Line %d:</b> %s. Forms wait until you correct it here."
              .formatted(at.line(), escaped(fault.get().message())));
      markLine(document().offset(Math.max(1, at.line()), Math.max(1, at.column())));
    } else {
      locked.ifPresent(why -> notice.setText("<html><b>Read only:</b> " + escaped(why)));
    }
  }

  private static String escaped(String message) {
    return Markup.text(message);
  }

  private void markLine(int offset) {
    try {
      if (page.holds(offset)) {
        int line = area.getLineOfOffset(text.inShown(offset - page.from()));
        faultLine = area.addLineHighlight(line, SourceStyle.errorLine());
      }
    } catch (BadLocationException e) {
      faultLine = null; // the text ends before the place: nothing to mark
    }
  }

  /** Brings the place where the text stops being well formed into view. */
  public void showFault() {
    document()
        .fault()
        .ifPresent(
            fault -> {
              Location at = fault.location();
              reveal(document().offset(Math.max(1, at.line()), Math.max(1, at.column())));
            });
  }

  /** Brings a character into view and puts the caret there. */
  public void reveal(int offset) {
    if (!page.holds(offset)) {
      turn(offset);
    }
    boolean before = following;
    following = true;
    try {
      area.setCaretPosition(text.inShown(offset - page.from()));
      var shown = area.modelToView2D(area.getCaretPosition());
      if (shown != null) {
        var target = shown.getBounds();
        target.grow(0, area.getVisibleRect().height / 3);
        target.x = 0;
        area.scrollRectToVisible(target);
      }
    } catch (BadLocationException e) {
      throw new IllegalStateException("the caret is outside of the text", e);
    } finally {
      following = before;
    }
  }

  private void caretMoved() {
    flush();
    int offset = page.from() + text.inFile(area.getCaretPosition());
    document()
        .tree()
        .flatMap(tree -> tree.at(offset))
        .ifPresent(element -> session.select(element, this));
    mark(session.selection());
  }

  private void follow(Optional<DocumentElement> element, Object origin) {
    boolean typingHere = origin == session && area.isFocusOwner();
    if (origin != this && !typingHere && !following) {
      flush();
      element.filter(DocumentElement::attached).ifPresent(each -> reveal(each.start()));
    }
    mark(element);
  }

  private void mark(Optional<DocumentElement> element) {
    if (tagMark != null) {
      area.getHighlighter().removeHighlight(tagMark);
      tagMark = null;
    }
    if (element.isEmpty() || !element.get().attached() || !page.holds(element.get().start())) {
      return;
    }
    int from = text.inShown(element.get().start() - page.from());
    int to = text.inShown(Math.min(element.get().tagEnd(), page.to()) - page.from());
    try {
      tagMark =
          area.getHighlighter()
              .addHighlight(from, to, new SmartHighlightPainter(SourceStyle.elementTag()));
    } catch (BadLocationException e) {
      throw new IllegalStateException("an element is outside of the text", e);
    }
  }

  /** Lets go of the session. */
  public void dispose() {
    typed.stop();
    moved.stop();
    UIManager.removePropertyChangeListener(restyling);
    session.removeSelectionListener(selecting);
    session.document().removeListener(changing);
  }
}
