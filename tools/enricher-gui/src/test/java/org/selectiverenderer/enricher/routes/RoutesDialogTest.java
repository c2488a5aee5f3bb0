package org.selectiverenderer.enricher.routes;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JTable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.enricher.robot.TestSessions;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.testing.robot.GuiRobot;

/** ROUTEs are added and deleted by hand. */
@ShowsWindows
class RoutesDialogTest {
  private static final String SCENE =
      """
        <TimeSensor DEF='Clock' loop='true'/>
        <OrientationInterpolator DEF='Turn' key='0 1' keyValue='0 1 0 0 0 1 0 3.14'/>
        <Transform DEF='Wheel'><Shape><Box/></Shape></Transform>
        <ROUTE fromNode='Clock' fromField='fraction_changed' toNode='Wheel' toField='rotation'/>
      """;

  @TempDir Path folder;

  @Test
  void onlyFieldsThatFitAreOfferedAndEachChangeIsOneStep() throws IOException {
    TestSessions.theme(false);
    EnricherSession session = TestSessions.with(folder, SCENE);
    String before = session.document().text().toString();
    GuiRobot hands = new GuiRobot();
    RoutesDialog dialog = GuiRobot.onEdt(() -> new RoutesDialog(null, session, () -> {}));
    hands.show(dialog);
    JTable table = GuiRobot.named(dialog, "ROUTEs of the scene", JTable.class);
    assertThat(GuiRobot.onEdt(() -> table.getValueAt(0, RoutesTableModel.FAULT)))
        .isEqualTo("the fields differ in type");
    GuiRobot.onEdt(
        () -> {
          table.setRowSelectionInterval(0, 0);
          return null;
        });
    hands.click(GuiRobot.named(dialog, "Delete", JButton.class));
    hands.await("no route", () -> table.getRowCount() == 0);

    choose(dialog, "Node at the start", "Turn");
    choose(dialog, "Field at the start", "value_changed");
    assertThat(items(dialog, "Node at the end")).containsExactly("Wheel  (Transform)");
    assertThat(items(dialog, "Field at the end"))
        .containsExactly("rotation  (SFRotation)", "scaleOrientation  (SFRotation)");
    choose(dialog, "Field at the end", "rotation");
    GuiRobot.picture(dialog.getContentPane(), "routes", 1);
    hands.click(GuiRobot.named(dialog, "Add", JButton.class));
    hands.await("the route", () -> table.getRowCount() == 1);
    assertThat(GuiRobot.onEdt(() -> table.getValueAt(0, RoutesTableModel.FAULT))).isEqualTo("");
    assertThat(session.document().text().toString())
        .contains(
            "<ROUTE fromNode='Turn' fromField='value_changed' toNode='Wheel' toField='rotation'/>");
    assertThat(session.document().history().names())
        .containsExactly("Delete the ROUTE from Clock to Wheel", "Add a ROUTE from Turn to Wheel");
    GuiRobot.onEdt(
        () -> {
          session.document().history().undo();
          session.document().history().undo();
          return null;
        });
    assertThat(session.document().text().toString()).isEqualTo(before);
    hands.click(GuiRobot.named(dialog, "Close", JButton.class));
    hands.await("the end", () -> !dialog.isShowing());
  }

  private static List<String> items(RoutesDialog dialog, String name) {
    JComboBox<?> box = GuiRobot.named(dialog, name, JComboBox.class);
    return GuiRobot.onEdt(
        () ->
            IntStream.range(0, box.getItemCount())
                .mapToObj(i -> String.valueOf(box.getItemAt(i)))
                .toList());
  }

  private static void choose(RoutesDialog dialog, String name, String item) {
    JComboBox<?> box = GuiRobot.named(dialog, name, JComboBox.class);
    int index =
        IntStream.range(0, items(dialog, name).size())
            .filter(i -> items(dialog, name).get(i).startsWith(item + " "))
            .findFirst()
            .orElseThrow();
    GuiRobot.onEdt(
        () -> {
          box.setSelectedIndex(index);
          return null;
        });
  }
}
