package org.selectiverenderer.enricher;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Container;
import java.awt.Rectangle;
import java.awt.Toolkit;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.StringSelection;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import javax.swing.JComboBox;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.JTabbedPane;
import javax.swing.JTextField;
import javax.swing.JTree;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.enricher.robot.TestSessions;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.testing.robot.GuiRobot;
import org.selectiverenderer.x3d.source.DocumentElement;

/** Nodes edited in the tree with keys, mouse and menus. */
@ShowsWindows
@Timeout(value = 180, unit = TimeUnit.SECONDS)
class TreeEditingTest {
  private static final String NODES =
      """
      <Transform DEF='Chair' translation='1 0 0'>
        <Shape DEF='Seat'/>
      </Transform>
      <Group DEF='Room'/>
      <Group DEF='Hall'/>
      <Shape DEF='Wall'/>
      """;

  @TempDir Path folder;
  private final GuiRobot hands = new GuiRobot();
  private EnricherWindow window;
  private EnricherSession session;
  private JTree tree;

  @BeforeEach
  void open() throws IOException {
    Path settings = Files.createDirectories(folder.resolve("settings"));
    Files.writeString(settings.resolve("enricher.properties"), "theme=light\ntab=Help\n");
    window = GuiRobot.onEdt(() -> new EnricherWindow(settings, () -> {}));
    hands.show(window.frame());
    Path scene = TestSessions.with(folder, NODES).file().path();
    GuiRobot.onEdt(
        () -> {
          window.open(scene);
          return true;
        });
    hands.await("the scene", () -> window.session().isPresent());
    session = window.session().orElseThrow();
    tree = GuiRobot.named(content(), "Nodes of the scene", JTree.class);
    JComboBox<?> extent = GuiRobot.named(content(), "Nodes that the tree shows", JComboBox.class);
    GuiRobot.onEdt(
        () -> {
          extent.setSelectedIndex(1);
          return true;
        });
  }

  @AfterEach
  void close() {
    GuiRobot.onEdt(
        () -> {
          window.dispose();
          return true;
        });
  }

  private Container content() {
    return window.frame().getContentPane();
  }

  private void select(String... names) {
    hands.click(tree);
    hands.await("the tree's focus", tree::isFocusOwner);
    GuiRobot.onEdt(
        () -> {
          session.selectAll(Stream.of(names).map(this::named).toList(), this);
          return true;
        });
  }

  private DocumentElement named(String def) {
    return session.document().tree().orElseThrow().named(def).orElseThrow();
  }

  /** Waits until these elements are selected. */
  private void awaitSelected(String... elements) {
    hands.await(
        "the selection " + List.of(elements),
        () ->
            session.selectedElements().stream()
                .map(DocumentElement::toString)
                .toList()
                .equals(List.of(elements)));
  }

  /** Waits until an element has these children. */
  private void awaitChildren(String parent, String... names) {
    hands.await(
        "the nodes " + List.of(names) + " in " + parent,
        () -> names(parent).equals(List.of(names)));
  }

  private List<String> names(String parent) {
    DocumentElement of =
        parent.equals("Scene")
            ? session.document().tree().orElseThrow().scene().orElseThrow()
            : named(parent);
    return of.children().stream().map(each -> each.def().orElse("")).toList();
  }

  private void undo() {
    hands.press(KeyEvent.VK_CONTROL, KeyEvent.VK_Z);
  }

  @Test
  void keysCutCopyPasteDeleteAndDuplicateTheSelectedNodes() throws Exception {
    select("Room", "Wall");
    assertThat(GuiRobot.onEdt(tree::getSelectionCount)).isEqualTo(2);
    hands.press(KeyEvent.VK_CONTROL, KeyEvent.VK_X);
    awaitChildren("Scene", "Chair", "Hall");
    Object clipboard =
        GuiRobot.onEdt(
            () ->
                Toolkit.getDefaultToolkit().getSystemClipboard().getData(DataFlavor.stringFlavor));
    assertThat(clipboard).isEqualTo("<Group DEF='Room'/>\n<Shape DEF='Wall'/>\n");
    awaitSelected("Group Hall");
    hands.press(KeyEvent.VK_CONTROL, KeyEvent.VK_V);
    awaitSelected("Group Room", "Shape Wall");
    awaitChildren("Hall", "Room", "Wall");
    hands.press(KeyEvent.VK_DELETE);
    awaitChildren("Hall");
    undo();
    undo();
    undo();
    awaitChildren("Scene", "Chair", "Room", "Hall", "Wall");
    select("Chair");
    hands.press(KeyEvent.VK_CONTROL, KeyEvent.VK_D);
    awaitSelected("Transform Chair_2");
    hands.press(KeyEvent.VK_CONTROL, KeyEvent.VK_D);
    awaitSelected("Transform Chair_3");
    awaitChildren("Scene", "Chair", "Chair_2", "Chair_3", "Room", "Hall", "Wall");
    select("Hall");
    hands.press(KeyEvent.VK_ALT, KeyEvent.VK_UP);
    awaitChildren("Scene", "Chair", "Chair_2", "Chair_3", "Hall", "Room", "Wall");
    awaitSelected("Group Hall");
    hands.press(KeyEvent.VK_ALT, KeyEvent.VK_DOWN);
    awaitChildren("Scene", "Chair", "Chair_2", "Chair_3", "Room", "Hall", "Wall");
  }

  @Test
  void theEditMenuActsOnTheTextThatHasTheFocusAndElseOnNodes() throws Exception {
    select("Room");
    JTextField search = GuiRobot.named(content(), "Search nodes", JTextField.class);
    hands.click(search);
    hands.write("ha");
    hands.press(KeyEvent.VK_CONTROL, KeyEvent.VK_A);
    choose("Cut");
    hands.await("the cut text", () -> search.getText().isEmpty());
    awaitChildren("Scene", "Chair", "Room", "Hall", "Wall");
    hands.press(KeyEvent.VK_DELETE);
    awaitChildren("Scene", "Chair", "Room", "Hall", "Wall");
    choose("Paste");
    hands.await("the pasted text", () -> search.getText().equals("ha"));
    GuiRobot.onEdt(
        () -> {
          search.setText("");
          return true;
        });
    select("Room");
    choose("Delete");
    awaitChildren("Scene", "Chair", "Hall", "Wall");
  }

  @Test
  void aKeyInAFormDeletesNoNode() {
    select("Room");
    JTabbedPane views = GuiRobot.named(content(), "Views of the scene", JTabbedPane.class);
    GuiRobot.onEdt(views::requestFocusInWindow);
    hands.await("the focus of the tabs", views::isFocusOwner);
    hands.press(KeyEvent.VK_DELETE);
    hands.press(KeyEvent.VK_CONTROL, KeyEvent.VK_X);
    awaitChildren("Scene", "Chair", "Room", "Hall", "Wall");
  }

  private void choose(String item) {
    JMenu edit = GuiRobot.onEdt(() -> window.frame().getJMenuBar().getMenu(1));
    hands.click(edit);
    hands.await("the menu", edit::isPopupMenuVisible);
    JMenuItem chosen =
        GuiRobot.onEdt(
            () ->
                Stream.of(edit.getMenuComponents())
                    .filter(JMenuItem.class::isInstance)
                    .map(JMenuItem.class::cast)
                    .filter(each -> each.getText().equals(item))
                    .findFirst()
                    .orElseThrow());
    hands.click(chosen);
  }

  @Test
  void rowsAreDraggedIntoAndBetweenOthersAndWithControlCopied() {
    hands.click(tree);
    drag("Wall", "Room", 0.5);
    awaitChildren("Room", "Wall");
    awaitSelected("Shape Wall");
    drag("Hall", "Chair", 0.05);
    GuiRobot.picture(window.frame().getRootPane(), "tree-drag", 1);
    awaitChildren("Scene", "Hall", "Chair", "Room");
    String before = GuiRobot.onEdt(() -> session.document().snapshot().text());
    drag("Room", "Wall", 0.5);
    assertThat(GuiRobot.onEdt(() -> session.document().snapshot().text())).isEqualTo(before);
    assertThat(before.toLowerCase(Locale.ROOT)).contains("<group def='room'>");
  }

  private void drag(String from, String to, double share) {
    Rectangle one = row(from);
    Rectangle other = row(to);
    Rectangle all = GuiRobot.onEdt(() -> new Rectangle(tree.getSize()));
    hands.drag(
        tree,
        (one.x + 30.0) / all.width,
        (one.y + one.height / 2.0) / all.height,
        (other.x + 30.0) / all.width,
        (other.y + other.height * share) / all.height);
  }

  private Rectangle row(String name) {
    return GuiRobot.onEdt(
        () -> {
          for (int row = 0; row < tree.getRowCount(); row++) {
            if (tree.getPathForRow(row).getLastPathComponent() instanceof DocumentElement each
                && each.def().filter(name::equals).isPresent()) {
              return tree.getRowBounds(row);
            }
          }
          throw new AssertionError("no row shows " + name);
        });
  }

  @Test
  void aNodeOfAnotherProgramIsPasted() {
    GuiRobot.onEdt(
        () -> {
          Toolkit.getDefaultToolkit()
              .getSystemClipboard()
              .setContents(new StringSelection("DEF Pot Transform { }"), null);
          return true;
        });
    select("Room");
    hands.press(KeyEvent.VK_CONTROL, KeyEvent.VK_V);
    awaitSelected("Transform Pot");
  }
}
