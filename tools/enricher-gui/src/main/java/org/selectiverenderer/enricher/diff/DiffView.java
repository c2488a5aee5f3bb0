package org.selectiverenderer.enricher.diff;

import java.awt.Component;
import java.awt.Font;
import javax.swing.AbstractListModel;
import javax.swing.BorderFactory;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JList;
import javax.swing.ListSelectionModel;
import javax.swing.UIManager;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.swing.PlainText;

/**
 * A list of the lines of a diff. Only visible lines are laid out, so a million of them scroll like
 * ten.
 */
@SuppressWarnings("serial") // never written
final class DiffView extends JList<DiffLines.Line> {
  private static final long serialVersionUID = 1L;

  /** Longer lines are cut: an IndexedFaceSet can have all its numbers in one. */
  private static final int LONGEST = 400;

  /** Characters of a cut line, which has its difference in the first third of them. */
  private static final int EXCERPT = 180;

  private DiffLines diff = DiffLines.of("");

  DiffView() {
    Font plain = UIManager.getFont("monospaced.font");
    if (plain == null) {
      plain = new Font(Font.MONOSPACED, Font.PLAIN, getFont().getSize());
    }
    setFont(plain);
    setSelectionMode(ListSelectionModel.SINGLE_INTERVAL_SELECTION);
    setCellRenderer(new LineRenderer());
    getAccessibleContext().setAccessibleName(Texts.of("diff.view"));
  }

  void show(DiffLines lines) {
    diff = lines;
    int longest = 20;
    for (DiffLines.Line line : lines.lines()) {
      longest = Math.max(longest, Math.min(LONGEST, line.text().length()));
    }
    setFixedCellWidth(getFontMetrics(getFont()).charWidth('m') * (longest + 2));
    setFixedCellHeight(getFontMetrics(getFont()).getHeight() + 2);
    setModel(
        new AbstractListModel<>() {
          private static final long serialVersionUID = 1L;

          @Override
          public int getSize() {
            return lines.lines().size();
          }

          @Override
          public DiffLines.Line getElementAt(int index) {
            return lines.lines().get(index);
          }
        });
    if (!lines.changes().isEmpty()) {
      go(lines.changes().get(0));
    }
  }

  void next() {
    go(diff.next(getLeadSelectionIndex()));
  }

  void previous() {
    go(diff.previous(getLeadSelectionIndex()));
  }

  private void go(int line) {
    if (line >= 0) {
      setSelectedIndex(line);
      ensureIndexIsVisible(Math.min(getModel().getSize() - 1, line + 5));
      ensureIndexIsVisible(Math.max(0, line - 3));
    }
  }

  /** Returns a line as it is shown: a long one is cut around what differs. */
  private String cut(String line, int index) {
    String text = line.replace("\t", "  ");
    if (text.length() <= LONGEST) {
      return text;
    }
    String other = diff.beside(index).replace("\t", "  ");
    String without = other.isEmpty() ? "" : other.substring(1);
    return text.charAt(0) + LineExcerpt.of(text.substring(1), without, EXCERPT).text();
  }

  private final class LineRenderer extends DefaultListCellRenderer {
    private static final long serialVersionUID = 1L;

    LineRenderer() {
      PlainText.only(this); // a line of a scene may begin with <html>
    }

    @Override
    public Component getListCellRendererComponent(
        JList<?> list, Object value, int index, boolean selected, boolean focused) {
      DiffLines.Line line = (DiffLines.Line) value;
      String cut = cut(line.text(), index);
      super.getListCellRendererComponent(list, cut, index, false, false);
      setBackground(DiffColors.background(line.kind()));
      setFont(
          line.kind() == DiffLines.Kind.FILE ? list.getFont().deriveFont(Font.BOLD) : getFont());
      // The selected line keeps the colour of its kind; a bar in front marks it.
      setBorder(
          BorderFactory.createMatteBorder(
              0, 4, 0, 0, selected ? UIManager.getColor("Component.focusColor") : getBackground()));
      getAccessibleContext().setAccessibleName(line.kind().word() + ": " + cut);
      return this;
    }
  }
}
