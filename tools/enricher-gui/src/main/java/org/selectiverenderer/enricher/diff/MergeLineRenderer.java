package org.selectiverenderer.enricher.diff;

import java.awt.Color;
import java.awt.Component;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.font.FontRenderContext;
import java.util.Optional;
import java.util.function.IntPredicate;
import javax.swing.JTable;
import javax.swing.table.DefaultTableCellRenderer;
import org.selectiverenderer.authoring.file.ThreeWayMerge;
import org.selectiverenderer.base.markup.MarkupEscaper;
import org.selectiverenderer.swing.PlainText;

/**
 * Renders taken lines green with a plus, dropped lines red with a minus, and undecided lines blue.
 * What differs from the line beside it is marked, and is in view however long the line is.
 */
@SuppressWarnings("serial") // never written
final class MergeLineRenderer extends DefaultTableCellRenderer {
  private static final long serialVersionUID = 1L;

  /** Most characters of a line in a tip. */
  private static final int TIP = 1200;

  private final MergeRows rows;
  private final IntPredicate chosen;
  private String sign = "";
  private LineExcerpt shown = new LineExcerpt("", 0, 0, false);
  private Color back = Color.WHITE;
  private Color mark = Color.WHITE;

  /**
   * @param chosen whether the conflict of a number is selected
   */
  MergeLineRenderer(MergeRows rows, IntPredicate chosen) {
    this.rows = rows;
    this.chosen = chosen;
  }

  @Override
  public Component getTableCellRendererComponent(
      JTable table, Object value, boolean selected, boolean focused, int row, int column) {
    MergeRows.Row line = rows.rows().get(row);
    Optional<Boolean> taken = rows.taken(line, column == 0);
    boolean same = line.kind() == ThreeWayMerge.Kind.SAME;
    String text = column == 0 ? line.mine() : line.theirs();
    String other = column == 0 ? line.theirs() : line.mine();
    sign = same ? "  " : taken.map(is -> is ? "+ " : "\u2212 ").orElse("? ");
    sign = text.isEmpty() ? "" : sign;
    super.getTableCellRendererComponent(table, "", false, focused, row, column);
    boolean bold = line.conflict() >= 0 && chosen.test(line.conflict());
    setFont(bold ? table.getFont().deriveFont(Font.BOLD) : table.getFont());
    FontMetrics letters = getFontMetrics(getFont());
    int width = table.getColumnModel().getColumn(column).getWidth();
    int room = width / Math.max(1, letters.charWidth('m')) - sign.length() - 1;
    shown = LineExcerpt.of(text, other, room);
    PlainText.only(this); // a line may begin with <html>
    setText(sign + shown.text());
    setToolTipText(shown.cut() ? tip(text, other) : null);
    DiffLines.Kind kind =
        same || text.isEmpty()
            ? DiffLines.Kind.SAME
            : taken
                .map(is -> is ? DiffLines.Kind.ADDED : DiffLines.Kind.REMOVED)
                .orElse(DiffLines.Kind.PLACE);
    back = DiffColors.background(kind);
    mark = same || other.isEmpty() ? back : DiffColors.marked(kind);
    setOpaque(false);
    return this;
  }

  /** Returns the whole line, or of a very long one what is around the difference. */
  private static String tip(String text, String other) {
    String line = LineExcerpt.of(text, other, TIP).text();
    return "<html><body width=480>" + MarkupEscaper.text(line);
  }

  @Override
  protected void paintComponent(Graphics g) {
    g.setColor(back);
    g.fillRect(0, 0, getWidth(), getHeight());
    if (shown.from() < shown.to()) {
      int x = getInsets().left + width(g, sign + shown.text().substring(0, shown.from()));
      g.setColor(mark);
      g.fillRect(x, 0, width(g, shown.text().substring(shown.from(), shown.to())), getHeight());
    }
    super.paintComponent(g);
  }

  /** Returns the width of a text as it is painted, which the scale of the screen changes a bit. */
  private int width(Graphics g, String text) {
    FontRenderContext scale = ((Graphics2D) g).getFontRenderContext();
    return (int) Math.round(getFont().getStringBounds(text, scale).getWidth());
  }
}
