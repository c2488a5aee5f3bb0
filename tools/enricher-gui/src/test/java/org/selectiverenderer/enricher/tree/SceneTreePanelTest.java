package org.selectiverenderer.enricher.tree;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Rectangle;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import javax.swing.JFrame;
import javax.swing.JTree;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.enricher.robot.TestSessions;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.testing.robot.GuiRobot;

@ShowsWindows
class SceneTreePanelTest {
  private static final int DEPTH = 40;

  @TempDir Path folder;
  private final GuiRobot hands = new GuiRobot();

  @Test
  void ofADeepNodeThatIsSelectedAllLettersAreSeen() throws IOException {
    String nodes =
        "<Group>".repeat(DEPTH) + "<Transform DEF='LampOfTheDesk'/>" + "</Group>".repeat(DEPTH);
    EnricherSession session = TestSessions.with(folder, nodes);
    SceneTreePanel panel = GuiRobot.onEdt(() -> new SceneTreePanel(session, element -> false));
    JFrame frame =
        GuiRobot.onEdt(
            () -> {
              JFrame made = new JFrame();
              made.setContentPane(panel.component());
              made.setSize(230, 500);
              return made;
            });
    hands.show(frame);
    try {
      JTree tree = panel.tree();
      GuiRobot.onEdt(
          () -> {
            var lamp = session.document().tree().orElseThrow().named("LampOfTheDesk");
            panel.reveal(lamp.orElseThrow());
            session.select(lamp.orElseThrow(), this);
            return true;
          });
      hands.await(
          "the row",
          () -> {
            Rectangle row = tree.getPathBounds(tree.getSelectionPath());
            Rectangle seen = tree.getVisibleRect();
            // A theme's rows may be wider than the view, in which the arrows before them are too.
            row.width = Math.min(row.width, seen.width - 40);
            return seen.contains(row);
          });
      assertThat(GuiRobot.onEdt(() -> tree.getVisibleRect().x))
          .as("how far it is scrolled sideways")
          .isPositive();
      GuiRobot.picture(frame.getContentPane(), "tree-deep", 1);
    } finally {
      GuiRobot.onEdt(
          () -> {
            frame.dispose();
            panel.dispose();
            return true;
          });
    }
  }

  @Test
  void aLongNameThatIsSelectedLeavesTheArrowsInView() throws IOException {
    String name = "Switch_of_the_lamp_on_the_desk_beside_the_window_of_the_office";
    EnricherSession session =
        TestSessions.with(folder, "<Group><Group DEF='" + name + "'><Group/></Group></Group>");
    SceneTreePanel panel = GuiRobot.onEdt(() -> new SceneTreePanel(session, element -> false));
    JFrame frame =
        GuiRobot.onEdt(
            () -> {
              JFrame made = new JFrame();
              made.setContentPane(panel.component());
              made.setSize(230, 500);
              return made;
            });
    hands.show(frame);
    try {
      GuiRobot.onEdt(
          () -> {
            session.select(session.document().tree().orElseThrow().named(name).orElseThrow(), this);
            return true;
          });
      hands.await("the selection", () -> panel.tree().getSelectionCount() == 1);
      GuiRobot.onEdt(() -> true); // after what is done later for the scroll bar
      assertThat(GuiRobot.onEdt(() -> panel.tree().getVisibleRect().x)).isZero();
    } finally {
      GuiRobot.onEdt(
          () -> {
            frame.dispose();
            panel.dispose();
            return true;
          });
    }
  }

  @Test
  void anElementWithoutANameHasAHintOfWhatIsInIt() throws IOException {
    EnricherSession session =
        TestSessions.with(
            folder,
            """
            <Transform><ProtoInstance name='Lamp'/></Transform>
            <Transform><Shape><IndexedFaceSet coordIndex='0 1 2 3 -1'/></Shape></Transform>
            <Transform DEF='Desk'/>
            """);
    SceneTreePanel panel = GuiRobot.onEdt(() -> new SceneTreePanel(session, element -> false));
    JTree tree = panel.tree();
    List<String> names =
        GuiRobot.onEdt(
            () ->
                session.document().tree().orElseThrow().scene().orElseThrow().children().stream()
                    .map(
                        element ->
                            tree.getCellRenderer()
                                .getTreeCellRendererComponent(
                                    tree, element, false, false, false, 0, false)
                                .getAccessibleContext()
                                .getAccessibleName())
                    .toList());
    assertThat(names)
        .containsExactly(
            "Transform, Lamp", "Transform, IndexedFaceSet, 2 polygons", "Transform  Desk");
    JFrame frame =
        GuiRobot.onEdt(
            () -> {
              JFrame made = new JFrame();
              made.setContentPane(panel.component());
              made.setSize(330, 300);
              return made;
            });
    hands.show(frame);
    GuiRobot.picture(frame.getContentPane(), "tree-hints", 2);
    GuiRobot.onEdt(
        () -> {
          frame.dispose();
          panel.dispose();
          return true;
        });
  }
}
