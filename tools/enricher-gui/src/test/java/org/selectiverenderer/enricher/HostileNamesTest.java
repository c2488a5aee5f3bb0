package org.selectiverenderer.enricher;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.Container;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;
import javax.swing.AbstractButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JTabbedPane;
import javax.swing.JTable;
import javax.swing.JTree;
import javax.swing.plaf.basic.BasicHTML;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.testing.robot.GuiRobot;

/** No name in a scene is shown as HTML, in no view of the window. */
@ShowsWindows
@Timeout(value = 180, unit = TimeUnit.SECONDS)
class HostileNamesTest {
  private static final String MARK = "<b>desk";

  @TempDir Path folder;
  private final GuiRobot hands = new GuiRobot();
  private final Set<String> shown = new TreeSet<>();

  @Test
  void namesOfAScenesNodesAreNoHtml() throws IOException {
    Path scene = folder.resolve("scene.x3d");
    Files.writeString(
        scene,
        """
        <X3D profile='Immersive' version='4.0'><head>
        <meta name='@' content='@'/></head><Scene>
        <Viewpoint DEF='@1' description='@'/>
        <Transform DEF='@2'><Switch DEF='@3' whichChoice='0'>
        <MetadataSet name='@' containerField='metadata'>
        <MetadataString name='@' value='"@"' containerField='value'/></MetadataSet>
        <Inline DEF='@4' url='"@.x3d"'/></Switch></Transform>
        <ProximitySensor DEF='@5' size='1 1 1'/>
        <Group DEF='@6' nonsense='@' visible='@'/></Scene></X3D>
        """
            .replace("@", "&lt;html>&lt;b>desk"));
    Path settings = Files.createDirectories(folder.resolve("settings"));
    EnricherWindow window = GuiRobot.onEdt(() -> new EnricherWindow(settings, () -> {}));
    try {
      hands.show(window.frame());
      GuiRobot.onEdt(
          () -> {
            window.open(scene);
            return true;
          });
      hands.await("the scene", () -> window.session().isPresent());
      assertThat(
              GuiRobot.onEdt(
                  () -> {
                    look(window.frame());
                    return shown;
                  }))
          .isEmpty();
    } finally {
      GuiRobot.onEdt(
          () -> {
            window.dispose();
            return true;
          });
    }
  }

  /** Looks at a component and all inside it, and selects what can be selected. */
  private void look(Component component) {
    note(component, component);
    if (component instanceof JTree tree) {
      for (int row = 0; row < tree.getRowCount(); row++) {
        tree.expandRow(row);
        note(
            tree,
            tree.getCellRenderer()
                .getTreeCellRendererComponent(
                    tree,
                    tree.getPathForRow(row).getLastPathComponent(),
                    false,
                    true,
                    true,
                    row,
                    false));
        tree.setSelectionRow(row); // shows the node's form
        Container all = tree.getTopLevelAncestor();
        all.validate();
        labels(all);
      }
    } else if (component instanceof JTable table) {
      for (int row = 0; row < table.getRowCount(); row++) {
        for (int column = 0; column < table.getColumnCount(); column++) {
          note(table, table.prepareRenderer(table.getCellRenderer(row, column), row, column));
        }
      }
    } else if (component instanceof JList<?> list) {
      entries(list);
    }
    if (component instanceof JTabbedPane tabs) {
      for (int i = 0; i < tabs.getTabCount(); i++) {
        tabs.setSelectedIndex(i);
        tabs.validate();
      }
    }
    if (component instanceof Container container) {
      for (Component inside : container.getComponents()) {
        look(inside);
      }
    }
  }

  private void labels(Container container) {
    for (Component inside : container.getComponents()) {
      note(inside, inside);
      if (inside instanceof Container more) {
        labels(more);
      }
    }
  }

  private <T> void entries(JList<T> list) {
    for (int i = 0; i < list.getModel().getSize(); i++) {
      note(
          list,
          list.getCellRenderer()
              .getListCellRendererComponent(
                  list, list.getModel().getElementAt(i), i, false, false));
    }
  }

  private void note(Component where, Component component) {
    String text =
        component instanceof JLabel label
            ? label.getText()
            : component instanceof AbstractButton button ? button.getText() : null;
    if (component instanceof JComponent drawn) {
      if (drawn.getClientProperty(BasicHTML.propertyKey) != null
          && text != null
          && text.contains(MARK)) {
        shown.add(where.getClass().getName() + " shows " + text);
      }
      String tip = drawn.getToolTipText();
      if (tip != null && BasicHTML.isHTMLString(tip) && tip.contains(MARK)) {
        shown.add(where.getClass().getName() + " tells " + tip);
      }
    }
  }
}
