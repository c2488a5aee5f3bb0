package org.selectiverenderer.enricher;

import java.awt.Container;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.JTabbedPane;
import org.selectiverenderer.enricher.text.Texts;

/** The views of a document in tabs, of which the settings remember the selected one by its name. */
final class ViewTabs {
  private final JTabbedPane tabs = new JTabbedPane();
  private final List<String> names = new ArrayList<>();

  ViewTabs() {
    tabs.getAccessibleContext().setAccessibleName(Texts.of("window.views"));
  }

  /**
   * Adds a view.
   *
   * @param name by which the settings remember it in every language
   */
  void add(String name, String title, JComponent view) {
    names.add(name);
    tabs.addTab(title, view);
  }

  JTabbedPane component() {
    return tabs;
  }

  /** The view in front. */
  Container selected() {
    return (Container) tabs.getSelectedComponent();
  }

  /** The name of the view in front. */
  String selectedName() {
    return names.get(tabs.getSelectedIndex());
  }

  /** Brings the view of that name to the front; the first one if there is none. */
  void select(String name) {
    tabs.setSelectedIndex(Math.max(0, names.indexOf(name)));
  }

  /** Brings a view to the front; returns whether it was behind others. */
  boolean bringToFront(JComponent view) {
    if (selected() == view) {
      return false;
    }
    tabs.setSelectedComponent(view);
    settleFocus();
    return true;
  }

  /** Brings a view to the front and gives it the focus, so that its keys work at once. */
  void show(int index) {
    if (index < tabs.getTabCount()) {
      tabs.setSelectedIndex(index);
      settleFocus();
      new FocusCycler(List.of(selected())).next();
    }
  }

  /**
   * Lays the tabs out at once: the layout gives the focus of a hidden view to the first component
   * of the one in front, and would take it from the one for which it is asked next.
   */
  private void settleFocus() {
    tabs.validate();
  }
}
