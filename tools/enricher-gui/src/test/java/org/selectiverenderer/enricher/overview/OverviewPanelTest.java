package org.selectiverenderer.enricher.overview;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JFrame;
import javax.swing.JRootPane;
import javax.swing.JTable;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.enricher.robot.TestSessions;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.testing.robot.GuiRobot;

/** The table is filled with keys only. */
@ShowsWindows
class OverviewPanelTest {
  private static final String AREA =
      """
      <ProximitySensor DEF='Prox' size='1 1 1'>
        <MetadataSet name='schemaDefinition' containerField='metadata'>
          <MetadataString name='enterTimeSchema' value='"A"' containerField='value'/>
        </MetadataSet>
      </ProximitySensor>
      """;

  @TempDir Path folder;
  private final GuiRobot hands = new GuiRobot();

  private JTable shown(EnricherSession session) {
    JFrame frame =
        GuiRobot.onEdt(
            () -> {
              JFrame made = new JFrame("overview");
              made.setDefaultCloseOperation(JFrame.DISPOSE_ON_CLOSE);
              made.setContentPane(new OverviewPanel(session));
              made.setSize(900, 500);
              return made;
            });
    hands.show(frame);
    return GuiRobot.named(frame, "Degrees of objects by schemas", JTable.class);
  }

  private static void close(JTable table) {
    GuiRobot.onEdt(
        () -> {
          javax.swing.SwingUtilities.getWindowAncestor(table).dispose();
          return true;
        });
  }

  @Test
  void inANarrowWindowNothingIsCutOff() throws IOException {
    TestSessions.theme(false);
    JTable table = shown(TestSessions.with(folder, AREA + TestSessions.object("Sink")));
    JRootPane root = SwingUtilities.getRootPane(table);
    GuiRobot.onEdt(
        () -> {
          SwingUtilities.getWindowAncestor(table).setSize(360, 640);
          return true;
        });
    List<JButton> buttons =
        Stream.of(Texts.of("overview.remove.name"), Texts.of("overview.clear"))
            .map(name -> GuiRobot.named(root.getContentPane(), name, JButton.class))
            .toList();
    hands.await("narrow lines", () -> buttons.stream().allMatch(each -> inside(each, root)));
    close(table);
  }

  private static boolean inside(JButton button, JRootPane root) {
    Rectangle place = SwingUtilities.convertRectangle(button.getParent(), button.getBounds(), root);
    return root.getWidth() < 400 && root.getBounds().contains(place);
  }

  @Test
  void aShortcutWithADigitEditsNoCell() throws IOException {
    TestSessions.theme(false);
    JTable table = shown(TestSessions.with(folder, AREA + TestSessions.object("Sink")));
    hands.click(table, 0, 0);
    hands.press(KeyEvent.VK_CONTROL, KeyEvent.VK_2);
    assertThat(GuiRobot.onEdt(table::isEditing)).isFalse();
    close(table);
  }

  @Test
  void keysFillCellsAndTheRowIsTheSessionsSelection() throws IOException {
    TestSessions.theme(false);
    EnricherSession session =
        TestSessions.with(
            folder, AREA + TestSessions.object("Sink") + TestSessions.object("TrashCan"));
    JTable table = shown(session);
    hands.click(table, 0, 0);
    GuiRobot.picture(
        javax.swing.SwingUtilities.getRootPane(table).getContentPane(), "overview-findings", 1);
    assertThat(session.selection().orElseThrow().def()).contains("Switch_Sink");
    hands.press(KeyEvent.VK_SHIFT, KeyEvent.VK_DOWN);
    hands.press(KeyEvent.VK_H);
    assertThat(session.document().history().names()).containsExactly("Set 2 cells to high");
    hands.press(KeyEvent.VK_DOWN);
    hands.press(KeyEvent.VK_UP);
    hands.type("0.25");
    hands.press(KeyEvent.VK_ENTER);
    assertThat(session.document().history().names()).hasSize(2);
    hands.press(KeyEvent.VK_DELETE);
    assertThat(session.document().history().undoName())
        .hasValueSatisfying(name -> assertThat(name).startsWith("Clear"));
    GuiRobot.onEdt(
        () -> {
          session.select(session.enrichment().switches().get(1).element(), "the tree");
          return true;
        });
    assertThat(GuiRobot.onEdt(table::getSelectedRow)).isEqualTo(1);
    close(table);
  }

  @Test
  void tenThousandObjectsAreNoBurden() throws IOException {
    TestSessions.theme(true);
    String objects =
        IntStream.range(0, 10_000)
            .mapToObj(i -> TestSessions.object("Object" + i))
            .collect(Collectors.joining());
    EnricherSession session = TestSessions.with(folder, AREA + objects);
    JTable table = shown(session);
    assertThat(GuiRobot.onEdt(table::getRowCount)).isEqualTo(10_000);
    hands.click(table, 9_999, 0);
    assertThat(session.selection().orElseThrow().def()).contains("Switch_Object9999");
    hands.press(KeyEvent.VK_L);
    assertThat(GuiRobot.onEdt(() -> table.getValueAt(9_999, 0))).isEqualTo("low");
    close(table);
  }
}
