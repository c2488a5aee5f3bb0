package org.selectiverenderer.enricher.form;

import java.awt.Dimension;
import java.awt.Rectangle;
import javax.swing.JPanel;
import javax.swing.Scrollable;
import net.miginfocom.swing.MigLayout;

/** What scrolls in the form: as wide as there is room, as high as it needs. */
final class FormBody extends JPanel implements Scrollable {
  private static final long serialVersionUID = 1L;
  private static final int LINE = 24;

  FormBody() {
    super(new MigLayout("insets 10, gap 8, fillx, hidemode 3", "[grow,fill]", "[][][]"));
  }

  @Override
  public Dimension getPreferredScrollableViewportSize() {
    return getPreferredSize();
  }

  @Override
  public int getScrollableUnitIncrement(Rectangle visible, int orientation, int direction) {
    return LINE;
  }

  @Override
  public int getScrollableBlockIncrement(Rectangle visible, int orientation, int direction) {
    return visible.height - LINE;
  }

  @Override
  public boolean getScrollableTracksViewportWidth() {
    return true;
  }

  @Override
  public boolean getScrollableTracksViewportHeight() {
    return false;
  }
}
