package org.selectiverenderer.enricher;

import java.awt.Component;
import java.awt.Container;
import java.awt.FontMetrics;
import java.awt.Insets;
import java.util.ArrayList;
import java.util.List;
import javax.swing.AbstractButton;
import javax.swing.CellRendererPane;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JTextArea;
import javax.swing.JViewport;
import javax.swing.SwingConstants;

/** Finds texts of a window that have less room than they need. For the event dispatch thread. */
final class ClippedTexts {
  /** A line of text may be narrower than the form by so much, such as beside an icon. */
  private static final double COLUMN = 0.6;

  private ClippedTexts() {}

  /** The shown texts in a container that are cut off and have no tooltip that completes them. */
  static List<String> in(Container container) {
    List<String> found = new ArrayList<>();
    look(container, found);
    return found;
  }

  private static void look(Container in, List<String> found) {
    for (Component each : in.getComponents()) {
      if (!each.isVisible() || each instanceof CellRendererPane) {
        continue;
      }
      if (each instanceof JComponent component && component.isShowing()) {
        String text = text(component);
        if (!text.isBlank() && !text.startsWith("<html") && cut(component, text)) {
          found.add(component.getClass().getSimpleName() + ": " + text);
        }
      }
      if (each instanceof Container more && !(each instanceof JComboBox)) {
        look(more, found);
      }
    }
  }

  private static String text(JComponent component) {
    if (component instanceof JLabel label) {
      return String.valueOf(label.getText());
    } else if (component instanceof AbstractButton button) {
      return String.valueOf(button.getText());
    } else if (component instanceof JComboBox<?> box) {
      return String.valueOf(box.getSelectedItem());
    } else if (component instanceof JTextArea area) {
      return area.getText();
    }
    return "";
  }

  private static boolean cut(JComponent component, String text) {
    if (component instanceof JTextArea area) {
      return area.getLineWrap() && narrow(area);
    }
    FontMetrics metrics = component.getFontMetrics(component.getFont());
    Insets insets = component.getInsets();
    int icon = 0;
    if (component instanceof JLabel label && label.getIcon() != null) {
      icon = label.getIcon().getIconWidth() + label.getIconTextGap();
    } else if (component instanceof JComboBox<?> box) {
      return box.getWidth() < box.getPreferredSize().width
          && metrics.stringWidth(text) > box.getWidth() - box.getHeight() - 12;
    } else if (component instanceof AbstractButton button) {
      boolean beside = button.getHorizontalTextPosition() != SwingConstants.CENTER;
      icon =
          button.getIcon() != null && beside
              ? button.getIcon().getIconWidth() + button.getIconTextGap()
              : 0;
      return button.getWidth() > 0
          && metrics.stringWidth(text) + icon + insets.left + insets.right > button.getWidth();
    }
    boolean less =
        metrics.stringWidth(text) + icon + insets.left + insets.right > component.getWidth();
    return less && component.getToolTipText() == null;
  }

  /** Whether a wrapped text is in a column that is narrow in the pane that it is in. */
  private static boolean narrow(JTextArea area) {
    Container around = area.getParent();
    while (around != null && !(around instanceof JViewport)) {
      around = around.getParent();
    }
    return around != null
        && area.getLineCount() > 0
        && area.getWidth() < COLUMN * around.getWidth()
        && area.getFontMetrics(area.getFont()).stringWidth(area.getText()) > area.getWidth();
  }
}
