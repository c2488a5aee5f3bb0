package org.selectiverenderer.enricher.component;

import java.awt.Dimension;
import javax.accessibility.Accessible;
import javax.accessibility.AccessibleContext;
import javax.accessibility.AccessibleRole;
import javax.swing.JComponent;

/** A focusable component that paints itself; assistive technology sees it as a canvas. */
public abstract class AccessibleCanvas extends JComponent implements Accessible {
  private static final long serialVersionUID = 1L;

  /**
   * @param name for a screen reader
   */
  protected AccessibleCanvas(String name) {
    setFocusable(true);
    setOpaque(true);
    setPreferredSize(new Dimension(480, 360));
    setMinimumSize(new Dimension(80, 60));
    getAccessibleContext().setAccessibleName(name);
  }

  @Override
  public final AccessibleContext getAccessibleContext() {
    if (accessibleContext == null) {
      accessibleContext = new Canvas();
    }
    return accessibleContext;
  }

  private final class Canvas extends AccessibleJComponent {
    private static final long serialVersionUID = 1L;

    @Override
    public AccessibleRole getAccessibleRole() {
      return AccessibleRole.CANVAS;
    }
  }
}
