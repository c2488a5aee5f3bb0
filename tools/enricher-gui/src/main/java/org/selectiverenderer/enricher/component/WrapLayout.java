package org.selectiverenderer.enricher.component;

import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.FlowLayout;
import java.awt.Insets;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import javax.swing.JComponent;

/**
 * A flow layout whose preferred height includes the lines that components wrap into at the present
 * width.
 */
public final class WrapLayout extends FlowLayout {
  private static final long serialVersionUID = 1L;

  private WrapLayout(int between, int lines) {
    super(FlowLayout.LEADING, between, lines);
  }

  /**
   * Installs the layout in a component.
   *
   * @param between horizontal gap in pixels
   * @param lines vertical gap in pixels
   */
  public static void in(JComponent container, int between, int lines) {
    container.setLayout(new WrapLayout(between, lines));
    container.addComponentListener(
        new ComponentAdapter() {
          @Override
          public void componentResized(ComponentEvent event) {
            container.revalidate();
          }
        });
  }

  @Override
  public Dimension minimumLayoutSize(Container bar) {
    return new Dimension(1, preferredLayoutSize(bar).height);
  }

  @Override
  public Dimension preferredLayoutSize(Container bar) {
    Insets insets = bar.getInsets();
    int given = bar.getWidth() - insets.left - insets.right - 2 * getHgap();
    int most = given > 0 ? given : Integer.MAX_VALUE;
    int x = 0;
    int widest = 0;
    int line = 0;
    int height = 0;
    for (Component each : bar.getComponents()) {
      if (each.isVisible()) {
        Dimension size = each.getPreferredSize();
        if (x > 0 && x + getHgap() + size.width > most) {
          height += line + getVgap();
          x = 0;
          line = 0;
        }
        x += (x > 0 ? getHgap() : 0) + size.width;
        widest = Math.max(widest, x);
        line = Math.max(line, size.height);
      }
    }
    return new Dimension(
        widest + insets.left + insets.right + 2 * getHgap(),
        height + line + insets.top + insets.bottom + 2 * getVgap());
  }
}
