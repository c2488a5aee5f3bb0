package org.selectiverenderer.enricher.preview;

import java.awt.Component;
import java.awt.Container;
import java.util.ArrayList;
import java.util.List;
import javax.accessibility.Accessible;
import javax.swing.AbstractButton;
import javax.swing.JProgressBar;

/** Finds controls that a screen reader cannot name. */
final class AccessibleNames {
  private AccessibleNames() {}

  static List<Component> missing(Container in) {
    List<Component> missing = new ArrayList<>();
    for (Component child : in.getComponents()) {
      boolean control =
          child instanceof AbstractButton
              || child instanceof JProgressBar
              || child instanceof PictureView;
      if (control) {
        String name = ((Accessible) child).getAccessibleContext().getAccessibleName();
        if (name == null || name.isBlank()) {
          missing.add(child);
        }
      }
      if (child instanceof Container container) {
        missing.addAll(missing(container));
      }
    }
    return missing;
  }
}
