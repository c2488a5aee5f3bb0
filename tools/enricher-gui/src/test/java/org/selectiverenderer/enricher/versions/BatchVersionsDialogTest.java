package org.selectiverenderer.enricher.versions;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JSpinner;
import javax.swing.JTable;
import javax.swing.JTextField;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.authoring.enrichment.EnrichedSwitch;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.enricher.robot.TestSessions;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.models.simplify.SimplificationTarget;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.testing.robot.GuiRobot;
import org.selectiverenderer.x3d.source.DocumentElement;

/** Versions of many objects are made by hand: ticks, a goal for all, one step, undone. */
@ShowsWindows
class BatchVersionsDialogTest {
  private static final String OFFICE =
      """
        <!-- <html><b>vase</b> -->
        <Transform><Shape><Sphere radius='.2'/></Shape></Transform>
        <!-- bowl -->
        <Transform translation='2 0 0'><Shape><Sphere radius='.3'/></Shape></Transform>
        <Transform DEF='Shared' translation='4 0 0'><Shape DEF='Ball'><Sphere/></Shape></Transform>
        <Transform translation='6 0 0'><Shape USE='Ball'/></Transform>
        <Shape><Box size='9 .1 9'/></Shape>
      """;

  @TempDir Path folder;

  private final GuiRobot hands = new GuiRobot();

  private BatchVersionsDialog dialog(EnricherSession session) {
    BatchVersionsDialog dialog = GuiRobot.onEdt(() -> new BatchVersionsDialog(null, session));
    hands.show(dialog);
    return dialog;
  }

  @Test
  void tickedObjectsGetVersionsAsOneStep() throws IOException {
    TestSessions.theme(false);
    EnricherSession session = TestSessions.with(folder, OFFICE);
    String before = session.document().text().toString();
    BatchVersionsDialog dialog = dialog(session);
    JTable table = GuiRobot.named(dialog, "Objects to make versions of", JTable.class);
    JButton make = GuiRobot.named(dialog, "Make Versions", JButton.class);
    hands.await("the objects", () -> table.getRowCount() == 4 && make.isEnabled());
    assertThat(column(table, BatchTableModel.NAME))
        .containsExactly("Sphere", "Bowl", "Shared", "Ball_2");
    assertThat(column(table, BatchTableModel.CHOSEN))
        .containsExactly("true", "true", "true", "false");
    assertThat(column(table, BatchTableModel.REMARK).get(3)).contains("drawn elsewhere too (USE)");
    GuiRobot.picture(dialog.getContentPane(), "versions-many", 1);

    JTextField goal = GuiRobot.named(dialog, "Goal of all objects", JTextField.class);
    JComboBox<?> kind = GuiRobot.named(dialog, "What the goal means", JComboBox.class);
    GuiRobot.onEdt(
        () -> {
          kind.setSelectedItem(BatchGoal.Kind.TOLERANCE);
          goal.setText("2, 5");
          table.setValueAt("Vase", 0, BatchTableModel.NAME);
          table.setValueAt(false, 2, BatchTableModel.CHOSEN);
          table.setValueAt("no number", 1, BatchTableModel.GOAL);
          return null;
        });
    assertThat(column(table, BatchTableModel.GOAL)).containsOnly("2, 5");
    hands.click(make);
    hands.await("the end", () -> !dialog.isShowing());
    assertThat(session.document().history().names()).containsExactly("Make versions of 2 objects");
    assertThat(folder.resolve("inlineNodes/Vase_v3.x3d")).exists();
    assertThat(folder.resolve("inlineNodes/Bowl_v2.x3d")).exists();
    assertThat(session.enrichment().switches()).hasSize(2);
    assertThat(session.selectedElements())
        .as("the Switches, whose schemas are stated next")
        .containsExactlyElementsOf(
            session.enrichment().switches().stream().map(EnrichedSwitch::element).toList());
    session.document().history().undo();
    assertThat(session.document().text().toString()).isEqualTo(before);
    assertThat(folder.resolve("inlineNodes")).doesNotExist();
  }

  @Test
  void polygonsAreGroupedAndAShortcutEditsNoCell() throws IOException {
    TestSessions.theme(false);
    String many =
        "<Shape><ElevationGrid xDimension='40' zDimension='40' height='%s'/></Shape>"
            .formatted("0 1 ".repeat(800));
    BatchVersionsDialog dialog = dialog(TestSessions.with(folder, many));
    JTable table = GuiRobot.named(dialog, "Objects to make versions of", JTable.class);
    hands.await("the objects", () -> table.getRowCount() == 1);
    String shown =
        GuiRobot.onEdt(
            () ->
                ((JLabel)
                        table.prepareRenderer(
                            table.getCellRenderer(0, BatchTableModel.POLYGONS),
                            0,
                            BatchTableModel.POLYGONS))
                    .getText());
    assertThat(shown).isEqualTo(DecimalFormatter.grouped(2 * 39 * 39)).hasSize(5);
    hands.click(table, 0, BatchTableModel.GOAL);
    hands.press(KeyEvent.VK_CONTROL, KeyEvent.VK_2);
    assertThat(GuiRobot.onEdt(table::isEditing)).isFalse();
    hands.press(KeyEvent.VK_2);
    assertThat(GuiRobot.onEdt(table::isEditing)).isTrue();
    GuiRobot.onEdt(
        () -> {
          dialog.dispose();
          return null;
        });
  }

  @Test
  void selectedNodesAreTheTable() throws IOException {
    TestSessions.theme(false);
    EnricherSession session = TestSessions.with(folder, OFFICE);
    List<DocumentElement> nodes =
        session.document().tree().orElseThrow().scene().orElseThrow().children();
    int size = nodes.size();
    GuiRobot.onEdt(
        () -> {
          session.selectAll(List.of(nodes.get(size - 1), nodes.get(size - 4)), this);
          return null;
        });
    BatchVersionsDialog dialog = dialog(session);
    JTable table = GuiRobot.named(dialog, "Objects to make versions of", JTable.class);
    hands.await("the objects", () -> table.getRowCount() == 2);
    assertThat(column(table, BatchTableModel.CHOSEN)).containsExactly("true", "true");
    assertThat(column(table, BatchTableModel.NAME)).containsExactly("Bowl", "Box");
    hands.press(KeyEvent.VK_ESCAPE);
    hands.await("the end", () -> !dialog.isShowing());
    assertThat(session.document().modified()).isFalse();
  }

  @Test
  void whatTheAuthorTypedStaysWhenFewerObjectsAreShown() throws IOException {
    TestSessions.theme(false);
    BatchVersionsDialog dialog = dialog(TestSessions.with(folder, OFFICE));
    JTable table = GuiRobot.named(dialog, "Objects to make versions of", JTable.class);
    JSpinner fewest = GuiRobot.named(dialog, "Fewest polygons of an object", JSpinner.class);
    hands.await("the objects", () -> table.getRowCount() == 4);
    GuiRobot.onEdt(
        () -> {
          table.setValueAt("Vase", 0, BatchTableModel.NAME);
          table.setValueAt("30, 10", 0, BatchTableModel.GOAL);
          table.setValueAt(false, 2, BatchTableModel.CHOSEN);
          fewest.setValue(100_000);
          return null;
        });
    assertThat(column(table, BatchTableModel.NAME)).isEmpty();
    GuiRobot.onEdt(
        () -> {
          fewest.setValue(100);
          return null;
        });
    assertThat(column(table, BatchTableModel.NAME))
        .containsExactly("Vase", "Bowl", "Shared", "Ball_2");
    assertThat(column(table, BatchTableModel.GOAL)).containsExactly("30, 10", "50", "50", "50");
    assertThat(column(table, BatchTableModel.CHOSEN))
        .containsExactly("true", "true", "false", "false");
    hands.press(KeyEvent.VK_ESCAPE);
    hands.await("the end", () -> !dialog.isShowing());
  }

  @Test
  void whatIsNoGoalOrNameIsToldInASentence() throws IOException {
    TestSessions.theme(false);
    BatchVersionsDialog dialog = dialog(TestSessions.with(folder, OFFICE));
    JTable table = GuiRobot.named(dialog, "Objects to make versions of", JTable.class);
    JButton make = GuiRobot.named(dialog, "Make Versions", JButton.class);
    JTextField goal = GuiRobot.named(dialog, "Goal of all objects", JTextField.class);
    JLabel state = GuiRobot.named(dialog, "Result for the versions", JLabel.class);
    hands.await("the objects", () -> table.getRowCount() == 4 && make.isEnabled());
    GuiRobot.onEdt(
        () -> {
          goal.setText("1,5");
          return null;
        });
    assertThat(GuiRobot.onEdt(state::getText))
        .isEqualTo("1,5 may be one number or two: write 1.5, or 1, 5 with a space");
    assertThat(GuiRobot.onEdt(make::isEnabled)).isFalse();
    assertThat(column(table, BatchTableModel.GOAL)).containsOnly("50");
    GuiRobot.picture(dialog.getContentPane(), "versions-many-refused", 1);
    GuiRobot.onEdt(
        () -> {
          goal.setText("40");
          table.setValueAt("50f", 1, BatchTableModel.GOAL);
          return null;
        });
    assertThat(GuiRobot.onEdt(state::getText))
        .isEqualTo("50f is no number above 0 and at most 100");
    assertThat(column(table, BatchTableModel.GOAL)).containsOnly("40");
    assertThat(GuiRobot.onEdt(make::isEnabled)).isTrue();
    GuiRobot.onEdt(
        () -> {
          table.setValueAt("two words", 0, BatchTableModel.NAME);
          return null;
        });
    assertThat(GuiRobot.onEdt(state::getText)).startsWith("two words is no name");
    hands.press(KeyEvent.VK_ESCAPE);
    hands.await("the end", () -> !dialog.isShowing());
  }

  @Test
  void aPlanOfNothingSaysWhyAndWhatToDo() throws IOException {
    TestSessions.theme(false);
    EnricherSession session = TestSessions.with(folder, OFFICE);
    BatchVersionsDialog dialog = dialog(session);
    JTable table = GuiRobot.named(dialog, "Objects to make versions of", JTable.class);
    JButton make = GuiRobot.named(dialog, "Make Versions", JButton.class);
    JLabel state = GuiRobot.named(dialog, "Result for the versions", JLabel.class);
    JTextField goal = GuiRobot.named(dialog, "Goal of all objects", JTextField.class);
    hands.await("the objects", () -> table.getRowCount() == 4 && make.isEnabled());
    GuiRobot.onEdt(
        () -> {
          goal.setText("100");
          return null;
        });
    hands.click(make);
    hands.await("the reason", () -> state.getText().startsWith("Nothing was made"));
    assertThat(GuiRobot.onEdt(state::getText))
        .isEqualTo(
            "Nothing was made, for the reasons below; set a lower goal or tick other objects");
    JList<?> reasons = GuiRobot.named(dialog, "Problems of the versions", JList.class);
    assertThat(GuiRobot.onEdt(() -> String.valueOf(reasons.getModel().getElementAt(0))))
        .contains("cannot have fewer polygons");
    assertThat(session.document().modified()).isFalse();
    hands.press(KeyEvent.VK_ESCAPE);
    hands.await("the end", () -> !dialog.isShowing());
  }

  @Test
  void aGoalIsOneNumberForEachVersion() {
    BatchGoal goals = BatchGoal.read(BatchGoal.Kind.PERCENT, "50, 20;10 5.5");
    assertThat(goals.targets()).hasSize(4);
    assertThat(goals.targets().get(3)).isEqualTo(new SimplificationTarget.VertexPercent(5.5));
    assertThat(goals.fault()).isEmpty();
    // Three numbers can only be a list.
    for (String list : List.of("50,25,10", "50,25,10; 5.5", "50,25.5,10")) {
      BatchGoal read = BatchGoal.read(BatchGoal.Kind.PERCENT, list);
      assertThat(read.fault()).as(list).isEmpty();
      assertThat(read.targets()).as(list).hasSizeGreaterThanOrEqualTo(3);
    }
    for (String wrong :
        List.of(
            "50,25,",
            "50,,25",
            "50,25,101",
            "",
            "x",
            "0",
            "-1",
            "101",
            "NaN",
            "50f",
            "50d",
            "0x1p3",
            "1e1",
            "1,5",
            "50,20",
            "5 %",
            "1 2 3 4 5 6 7 8 9")) {
      BatchGoal read = BatchGoal.read(BatchGoal.Kind.TOLERANCE, wrong);
      assertThat(read.targets()).as(wrong).isEmpty();
      assertThat(read.fault()).as(wrong).isNotEmpty();
    }
    assertThat(Texts.of("manyversions.count", 1, "1", "3")).isEqualTo("1 object of 3 is ticked");
  }

  private static List<String> column(JTable table, int column) {
    return GuiRobot.onEdt(
        () ->
            IntStream.range(0, table.getRowCount())
                .mapToObj(row -> String.valueOf(table.getValueAt(row, column)))
                .toList());
  }
}
