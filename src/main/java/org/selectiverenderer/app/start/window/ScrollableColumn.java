package org.selectiverenderer.app.start.window;

import java.awt.Dimension;
import java.awt.LayoutManager;
import java.awt.Rectangle;
import javax.swing.JPanel;
import javax.swing.JViewport;
import javax.swing.Scrollable;
import javax.swing.SwingUtilities;

/** A panel as wide as its view, and as high where that is high enough; else it scrolls. */
final class ScrollableColumn extends JPanel implements Scrollable {
  private static final long serialVersionUID = 1;
  private static final int STEP = 24;

  ScrollableColumn(LayoutManager layout) {
    super(layout);
  }

  @Override
  public Dimension getPreferredScrollableViewportSize() {
    return getPreferredSize();
  }

  @Override
  public int getScrollableUnitIncrement(Rectangle visible, int orientation, int direction) {
    return STEP;
  }

  @Override
  public int getScrollableBlockIncrement(Rectangle visible, int orientation, int direction) {
    return visible.height;
  }

  @Override
  public boolean getScrollableTracksViewportWidth() {
    return true;
  }

  @Override
  public boolean getScrollableTracksViewportHeight() {
    JViewport view = (JViewport) SwingUtilities.getAncestorOfClass(JViewport.class, this);
    return view != null && view.getHeight() >= getMinimumSize().height;
  }
}
