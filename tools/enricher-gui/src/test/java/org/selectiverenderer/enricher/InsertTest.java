package org.selectiverenderer.enricher;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import javax.swing.JDialog;
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

/** Nodes inserted by menu, key and dialog. */
@ShowsWindows
@Timeout(value = 180, unit = TimeUnit.SECONDS)
class InsertTest {
  @TempDir Path folder;
  private final GuiRobot hands = new GuiRobot();
  private EnricherWindow window;
  private EnricherSession session;

  @BeforeEach
  void open() throws IOException {
    Path settings = Files.createDirectories(folder.resolve("settings"));
    Files.writeString(settings.resolve("enricher.properties"), "theme=light\ntab=Help\n");
    window = GuiRobot.onEdt(() -> new EnricherWindow(settings, () -> {}));
    hands.show(window.frame());
    Path scene =
        TestSessions.with(folder, "<Shape DEF='Seat'>\n  <Appearance DEF='Wood'/>\n</Shape>\n")
            .file()
            .path();
    GuiRobot.onEdt(
        () -> {
          window.open(scene);
          return true;
        });
    hands.await("the scene", () -> window.session().isPresent());
    session = window.session().orElseThrow();
  }

  @AfterEach
  void close() {
    GuiRobot.onEdt(
        () -> {
          window.dispose();
          return true;
        });
  }

  private void select(String def) {
    focusTree();
    GuiRobot.onEdt(
        () -> {
          session.select(session.document().tree().orElseThrow().named(def).orElseThrow(), this);
          return true;
        });
  }

  private void focusTree() {
    JTree tree = GuiRobot.named(window.frame().getContentPane(), "Nodes of the scene", JTree.class);
    hands.click(tree);
    hands.await("the tree's focus", tree::isFocusOwner);
  }

  private void awaitSelected(String element) {
    hands.await(
        "the selection of " + element,
        () ->
            session.selection().map(DocumentElement::toString).filter(element::equals).isPresent());
  }

  @Test
  void aNodeIsFoundByItsNameAndGoesIntoTheSelection() {
    select("Wood");
    hands.press(KeyEvent.VK_INSERT);
    JDialog dialog = hands.dialog(JDialog.class);
    hands.write("material");
    JTree nodes =
        GuiRobot.named(dialog.getContentPane(), "Nodes that may be inserted here", JTree.class);
    hands.await(
        "the found node",
        () -> "Material".equals(String.valueOf(nodes.getLastSelectedPathComponent())));
    GuiRobot.picture(dialog.getContentPane(), "insert-dialog", 1);
    hands.press(KeyEvent.VK_ENTER);
    awaitSelected("Material");
    assertThat(GuiRobot.onEdt(() -> session.document().snapshot().text()))
        .contains("<Appearance DEF='Wood'>\n    <Material/>\n  </Appearance>");
    focusTree(); // without a window manager the window has no keyboard after a dialog
    hands.press(KeyEvent.VK_CONTROL, KeyEvent.VK_Z);
    hands.await(
        "the undone step", () -> !session.document().snapshot().text().contains("Material"));
  }

  @Test
  void readyMadeThingsAreInTheMenu() {
    select("Seat");
    GuiRobot.onEdt(
        () -> {
          window.bench().orElseThrow().insert("box");
          return true;
        });
    awaitSelected("Transform Box");
    GuiRobot.onEdt(
        () -> {
          window.bench().orElseThrow().insert("view");
          return true;
        });
    awaitSelected("Viewpoint View");
    assertThat(GuiRobot.onEdt(() -> session.document().snapshot().text()))
        .contains("<Box size='1 1 1'/>");
  }
}
