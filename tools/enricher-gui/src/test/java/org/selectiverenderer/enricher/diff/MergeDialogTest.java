package org.selectiverenderer.enricher.diff;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JTable;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.authoring.file.ThreeWayMerge;
import org.selectiverenderer.authoring.file.ThreeWayMerge.Choice;
import org.selectiverenderer.enricher.robot.TestSessions;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.testing.robot.GuiRobot;

@ShowsWindows
class MergeDialogTest {
  private static final String BASE =
      "<X3D version='4.0'>\n<Scene>\n  <Shape DEF='Cup'/>\n  <Shape DEF='Pot'/>\n</Scene>\n</X3D>\n";

  private final ThreeWayMerge merge =
      ThreeWayMerge.of(
          Optional.of(BASE),
          BASE.replace("'Cup'", "'Mug'").replace("</X3D>", "</X3D><!-- mine -->"),
          BASE.replace("'Cup'", "'Glass'").replace("4.0", "3.3"));

  @Test
  void conflictsAreDecidedOneAfterTheOther() throws Exception {
    TestSessions.theme(false);
    GuiRobot hands = new GuiRobot();
    MergeDialog dialog = GuiRobot.onEdt(() -> new MergeDialog(null, merge));
    hands.show(dialog);
    JButton all = button(dialog, "apply");
    assertThat(GuiRobot.onEdt(all::isEnabled)).as("something is undecided").isFalse();
    hands.click(button(dialog, "mine.first"));
    hands.await("all decided", all::isEnabled);
    GuiRobot.picture(dialog.getContentPane(), "merge", 1);
    hands.click(all);
    hands.await("the end", () -> !dialog.isShowing());
    assertThat(GuiRobot.onEdt(dialog::choices)).contains(List.of(Choice.MINE_FIRST));
    assertThat(merge.text(List.of(Choice.MINE_FIRST)))
        .contains("3.3", "'Mug'", "'Glass'", "<!-- mine -->");
  }

  @Test
  void aLongLineShowsWhereItDiffersAndIsWholeInATip() throws Exception {
    String point =
        "  <Coordinate point='" + "1 2.5 -3 ".repeat(40) + "4" + " 5 6".repeat(40) + "'/>\n";
    String base = BASE.replace("  <Shape DEF='Pot'/>\n", point);
    ThreeWayMerge moved =
        ThreeWayMerge.of(
            Optional.of(base), base.replace("-3 4", "-3 7.75"), base.replace("-3 4", "-3 8.25"));
    for (boolean dark : new boolean[] {false, true}) {
      TestSessions.theme(dark);
      GuiRobot hands = new GuiRobot();
      MergeDialog dialog = GuiRobot.onEdt(() -> new MergeDialog(null, moved));
      hands.show(dialog);
      JTable table = GuiRobot.named(dialog, Texts.of("merge.table"), JTable.class);
      int row = GuiRobot.onEdt(table::getSelectedRow);
      for (int column = 0; column < 2; column++) {
        int at = column;
        JLabel cell =
            (JLabel)
                GuiRobot.onEdt(
                    () -> table.prepareRenderer(table.getCellRenderer(row, at), row, at));
        assertThat(cell.getText()).contains(column == 0 ? "7.75" : "8.25").contains("\u2026");
        assertThat(cell.getPreferredSize().width)
            .isLessThanOrEqualTo(table.getColumnModel().getColumn(column).getWidth());
        assertThat(cell.getToolTipText()).contains("Coordinate").contains("5 6'/&gt;");
      }
      GuiRobot.picture(dialog.getContentPane(), "merge-long-" + (dark ? "dark" : "light"), 2);
      GuiRobot.onEdt(
          () -> {
            dialog.dispose();
            return null;
          });
    }
  }

  private static JButton button(MergeDialog dialog, String key) {
    return GuiRobot.named(dialog, Texts.of("merge." + key), JButton.class);
  }
}
