package org.selectiverenderer.enricher.preview;

import javax.swing.JToolBar;
import org.selectiverenderer.enricher.parts.WrappingLines;

/** A tool bar whose buttons wrap into further lines where one has no room for all of them. */
class WrappingBar extends JToolBar {
  private static final long serialVersionUID = 1L;

  WrappingBar(String name) {
    super(name);
    setFloatable(false);
    WrappingLines.in(this, 2, 1);
    getAccessibleContext().setAccessibleName(name);
  }
}
