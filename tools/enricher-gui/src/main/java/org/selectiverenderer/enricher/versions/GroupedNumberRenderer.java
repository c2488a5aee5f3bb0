package org.selectiverenderer.enricher.versions;

import javax.swing.SwingConstants;
import javax.swing.table.DefaultTableCellRenderer;
import org.selectiverenderer.base.decimal.DecimalFormatter;

/** Renders whole numbers with separators between thousands, aligned to the right. */
final class GroupedNumberRenderer extends DefaultTableCellRenderer {
  private static final long serialVersionUID = 1L;

  GroupedNumberRenderer() {
    setHorizontalAlignment(SwingConstants.TRAILING);
  }

  @Override
  protected void setValue(Object value) {
    setText(value instanceof Number number ? DecimalFormatter.grouped(number.longValue()) : "");
  }
}
