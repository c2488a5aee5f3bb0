package org.selectiverenderer.enricher.preview;

import javax.swing.JToolBar;
import org.selectiverenderer.enricher.component.WrapLayout;

/** A tool bar whose buttons wrap into further lines where one has no room for all of them. */
class WrapToolBar extends JToolBar {
  private static final long serialVersionUID = 1L;

  WrapToolBar(String name) {
    super(name);
    setFloatable(false);
    WrapLayout.in(this, 2, 1);
    getAccessibleContext().setAccessibleName(name);
  }
}
