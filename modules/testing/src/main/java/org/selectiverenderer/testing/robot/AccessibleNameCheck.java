package org.selectiverenderer.testing.robot;

import java.awt.Component;
import java.awt.Container;
import java.util.ArrayList;
import java.util.List;
import javax.swing.AbstractButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JList;
import javax.swing.JProgressBar;
import javax.swing.JScrollBar;
import javax.swing.JSlider;
import javax.swing.JSplitPane;
import javax.swing.JTabbedPane;
import javax.swing.JTable;
import javax.swing.JTree;
import javax.swing.table.JTableHeader;
import javax.swing.text.JTextComponent;

/** Finds controls that a screen reader cannot name. */
public final class AccessibleNameCheck {
  private static final List<Class<?>> CONTROLS =
      List.of(
          AbstractButton.class,
          JTextComponent.class,
          JComboBox.class,
          JList.class,
          JTable.class,
          JTree.class,
          JTabbedPane.class,
          JSlider.class,
          JProgressBar.class);

  private AccessibleNameCheck() {}

  /** The controls without a name, shown or not. */
  public static List<String> missing(Container in) {
    List<String> missing = new ArrayList<>();
    for (Component child : in.getComponents()) {
      boolean known = CONTROLS.stream().anyMatch(type -> type.isInstance(child));
      if (child instanceof JComponent component && (known || ownKeys(component))) {
        String name = component.getAccessibleContext().getAccessibleName();
        if (name == null || name.isBlank()) {
          missing.add(component.getClass().getName() + " in " + in.getClass().getName());
        }
      }
      // What these are made of is theirs; only the split pane's sides are controls of ours.
      boolean whole =
          child instanceof JComboBox
              || child instanceof JScrollBar
              || child instanceof JTextComponent;
      if (!whole && child instanceof Container more && !divider(in, child)) {
        missing.addAll(missing(more));
      }
    }
    return missing;
  }

  /** A control that is painted by hand, such as a 3D picture. */
  private static boolean ownKeys(JComponent component) {
    boolean header = component instanceof JTableHeader; // the cells are what has the focus
    return !header
        && (component.getKeyListeners().length > 0 || component.getInputMap().size() > 0);
  }

  private static boolean divider(Container in, Component child) {
    return in instanceof JSplitPane split
        && child != split.getLeftComponent()
        && child != split.getRightComponent();
  }
}
