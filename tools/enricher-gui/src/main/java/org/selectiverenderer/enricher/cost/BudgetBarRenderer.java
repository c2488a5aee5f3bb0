package org.selectiverenderer.enricher.cost;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.util.Optional;
import javax.swing.JTable;
import javax.swing.table.DefaultTableCellRenderer;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.enricher.table.StatusColors;
import org.selectiverenderer.validation.budget.BudgetStatus;

/**
 * Renders the polygons of a row as a bar against its limit: blue up to the limit, orange and
 * hatched beyond it. A sign and words say the same without colours.
 */
final class BudgetBarRenderer extends DefaultTableCellRenderer {
  private static final long serialVersionUID = 1L;
  private static final int PAD = 3;

  /** Pixels between the lines of a hatching. */
  private static final int HATCH = 6;

  private transient Optional<CostRow> shown = Optional.empty();

  @Override
  public Component getTableCellRendererComponent(
      JTable table,
      @Nullable Object value,
      boolean selected,
      boolean focused,
      int row,
      int column) {
    shown = value instanceof CostRow cost ? Optional.of(cost) : Optional.empty();
    Optional<String> verdict = shown.flatMap(CostFormatter::verdict);
    boolean broken = shown.filter(CostRow::broken).isPresent();
    String words = verdict.map(text -> (broken ? "\u25b2 " : "\u2713 ") + text).orElse("");
    super.getTableCellRendererComponent(table, words, selected, focused, row, column);
    setToolTipText(verdict.isEmpty() ? null : words);
    return this;
  }

  @Override
  protected void paintComponent(Graphics g) {
    Optional<BudgetStatus> status = shown.flatMap(CostRow::status);
    if (status.isPresent()) {
      Graphics2D g2 = (Graphics2D) g.create();
      g2.setColor(getBackground());
      g2.fillRect(0, 0, getWidth(), getHeight());
      bar(g2, status.get());
      g2.dispose();
      setOpaque(false); // The text is painted over the bar.
      super.paintComponent(g);
      setOpaque(true);
    } else {
      super.paintComponent(g);
    }
  }

  private void bar(Graphics2D g, BudgetStatus status) {
    g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    double polygons = status.cost();
    double limit = status.limit();
    double most = Math.max(1, Math.max(polygons, limit));
    int width = getWidth() - 2 * PAD;
    int used = (int) Math.round(width * polygons / most);
    int end = (int) Math.round(width * limit / most);
    int height = getHeight() - 2 * PAD;
    Color ground = getBackground();
    g.setColor(StatusColors.tint(ground, StatusColors.NEUTRAL));
    g.fillRect(PAD, PAD, width, height);
    g.setColor(StatusColors.tint(ground, StatusColors.CALM));
    g.fillRect(PAD, PAD, Math.min(used, end), height);
    if (used > end) {
      g.setColor(StatusColors.tint(ground, StatusColors.ALERT));
      g.fillRect(PAD + end, PAD, used - end, height);
      Shape clip = g.getClip();
      g.clipRect(PAD + end, PAD, used - end, height);
      g.setColor(StatusColors.ALERT);
      for (int x = PAD + end - height; x < PAD + used; x += HATCH) {
        g.drawLine(x, PAD + height, x + height, PAD);
      }
      g.setClip(clip);
    }
    g.setColor(getForeground());
    g.setStroke(new BasicStroke(2));
    g.drawLine(PAD + end, 1, PAD + end, getHeight() - 2);
  }
}
