package org.selectiverenderer.enricher.ratings;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JButton;
import javax.swing.JTable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.enricher.robot.TestSessions;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.schema.ConsistencyType;
import org.selectiverenderer.study.gaze.GazeSimulator;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.testing.robot.GuiRobot;

/** A table of ratings is imported by hand: read, corrected, applied, undone. */
@ShowsWindows
class RatingsDialogTest {
  private static final String TABLE =
      """
      object,schema,rating
      Sink,KitchenSchema,5.5
      Sink,KitchenSchema,5
      Bin,KitchenSchema,2
      TrashCn,KitchenSchema,3.4
      """;

  @TempDir Path folder;

  @Test
  void ratingsAreReviewedCorrectedAndAppliedAsOneStep() throws IOException {
    TestSessions.theme(false);
    EnricherSession session =
        TestSessions.with(
            folder,
            TestSessions.object("Sink")
                + TestSessions.object("TrashCan")
                + TestSessions.object("Bucket"));
    String before = session.document().text().toString();
    Path table = Files.writeString(folder.resolve("ratings.csv"), TABLE);
    GuiRobot hands = new GuiRobot();
    RatingsDialog dialog = GuiRobot.onEdt(() -> new RatingsDialog(null, session));
    GuiRobot.onEdt(
        () -> {
          dialog.open(table);
          return true;
        });
    hands.show(dialog);
    JTable matches = GuiRobot.named(dialog, "Which Switch each object is", JTable.class);
    hands.await("the table", () -> matches.getRowCount() == 3);
    assertThat(GuiRobot.onEdt(() -> matches.getValueAt(0, 2))).isEqualTo("same name");
    assertThat(GuiRobot.onEdt(() -> matches.getValueAt(2, 1))).isEqualTo("Switch_TrashCan");

    hands.click(GuiRobot.named(dialog, "Accept Proposals", JButton.class));
    assertThat(GuiRobot.onEdt(() -> matches.getValueAt(2, 2))).isEqualTo("chosen");
    hands.click(matches, 1, MatchTableModel.SWITCH); // a list of Switches opens
    hands.press(KeyEvent.VK_DOWN);
    hands.press(KeyEvent.VK_ENTER);
    hands.await("the choice", () -> "Switch_Bucket".equals(matches.getValueAt(1, 1)));
    GuiRobot.picture(dialog.getContentPane(), "ratings-corrected", 1);

    hands.click(GuiRobot.named(dialog, "Apply", JButton.class));
    hands.await("the end", () -> !dialog.isShowing());
    assertThat(session.document().history().names())
        .containsExactly("Import ratings of ratings.csv");
    assertThat(session.enrichment().switchesByName().get("Switch_Sink").choices().get(1).values())
        .satisfies(values -> assertThat(values.schemas()).containsExactly("KitchenSchema"));
    session.document().history().undo();
    assertThat(session.document().text().toString()).isEqualTo(before);
  }

  @Test
  void columnsFitWhatTheySayAndWhatIsCutOffHasATooltip() throws IOException {
    TestSessions.theme(false);
    String name = "ARatherLongNameOfAPencilHolderOnTheShelfOfTheLibraryBesideTheDoorOfTheHall";
    EnricherSession session =
        TestSessions.with(folder, TestSessions.object("PencilHolder") + TestSessions.object(name));
    Path table =
        Files.writeString(
            folder.resolve("r.csv"),
            "object,schema,rating\nPencilHolder,OfficeSchema,6\nPencilHolder,DeskSchema,3.4\n");
    GuiRobot hands = new GuiRobot();
    RatingsDialog dialog = GuiRobot.onEdt(() -> new RatingsDialog(null, session));
    hands.show(dialog);
    open(dialog, table);
    JTable implied = GuiRobot.named(dialog, "What the ratings imply", JTable.class);
    hands.await("what follows", () -> implied.getRowCount() == 2);
    GuiRobot.picture(dialog.getContentPane(), "ratings-columns", 1);
    hands.await("the columns' widths", () -> cutOff(implied).isEmpty());

    Path other =
        Files.writeString(
            folder.resolve("o.csv"), "object,schema,rating\n" + name + ",OfficeSchema,6\n");
    open(dialog, other);
    JTable matches = GuiRobot.named(dialog, "Which Switch each object is", JTable.class);
    hands.await("the other table", () -> name.equals(matches.getValueAt(0, 0)));
    assertThat(GuiRobot.onEdt(() -> cutOff(matches))).contains(name);
    assertThat(GuiRobot.onEdt(() -> matches.getToolTipText(over(matches, 0, 0)))).isEqualTo(name);
    GuiRobot.onEdt(
        () -> {
          dialog.dispose();
          return true;
        });
  }

  private static void open(RatingsDialog dialog, Path table) {
    GuiRobot.onEdt(
        () -> {
          dialog.open(table);
          return true;
        });
  }

  private static List<String> cutOff(JTable table) {
    List<String> found = new ArrayList<>();
    for (int row = 0; row < table.getRowCount(); row++) {
      for (int column = 0; column < table.getColumnCount(); column++) {
        int needed =
            table
                .prepareRenderer(table.getCellRenderer(row, column), row, column)
                .getPreferredSize()
                .width;
        if (needed > table.getCellRect(row, column, false).width) {
          found.add(String.valueOf(table.getValueAt(row, column)));
        }
      }
    }
    return found;
  }

  private static MouseEvent over(JTable table, int row, int column) {
    Rectangle cell = table.getCellRect(row, column, false);
    return new MouseEvent(
        table, MouseEvent.MOUSE_MOVED, 0, 0, cell.x + 2, cell.y + 2, 0, false, MouseEvent.NOBUTTON);
  }

  @Test
  void aTableThatIsNoneIsNotUsedAndTheDialogSaysWhere() throws IOException {
    TestSessions.theme(true);
    EnricherSession session = TestSessions.with(folder, TestSessions.object("Sink"));
    Path table = Files.writeString(folder.resolve("bad.csv"), "object,schema,rating\nSink,A,9\n");
    GuiRobot hands = new GuiRobot();
    RatingsDialog dialog = GuiRobot.onEdt(() -> new RatingsDialog(null, session));
    hands.show(dialog);
    GuiRobot.onEdt(
        () -> {
          dialog.open(table);
          return true;
        });
    javax.swing.JList<?> problems =
        GuiRobot.named(dialog, "Problems of the table", javax.swing.JList.class);
    hands.await("the problem", () -> problems.getModel().getSize() == 1);
    assertThat(GuiRobot.onEdt(() -> problems.getModel().getElementAt(0).toString()))
        .startsWith("bad.csv:2:");
    assertThat(GuiRobot.named(dialog, "Apply", JButton.class).isEnabled()).isFalse();
    GuiRobot.picture(dialog.getContentPane(), "ratings-bad-dark", 1);
    hands.press(KeyEvent.VK_ESCAPE);
    hands.await("the end", () -> !dialog.isShowing());
    assertThat(session.document().modified()).isFalse();
  }

  @Test
  void proposalsFromLogsAreAcceptedOneByOneAndAppliedAsOneStep() throws IOException {
    TestSessions.theme(false);
    double[] attention = {1, -1, 0, 1, -1, 0, 1, -1, 0, 1, -1, 0};
    StringBuilder scene = new StringBuilder();
    for (int i = 1; i <= attention.length; i++) {
      scene.append(TestSessions.object("Object" + i));
    }
    EnricherSession session = TestSessions.with(folder, scene.toString());
    String before = session.document().text().toString();
    String name = String.valueOf(session.file().path().getFileName());
    GazeSimulator room =
        new GazeSimulator(name, List.of("OfficeSchema"), GazeSimulator.along(attention, 1));
    for (int p = 1; p <= 10; p++) {
      GazeSimulator.write(
          room.log(60, p), folder.resolve("logs/sub-%02d/ses-01/head/a_run-01.csv".formatted(p)));
    }
    Path ratings =
        Files.writeString(
            folder.resolve("r.csv"),
            "object,schema,rating\nObject1,OfficeSchema,6\nObject3,OfficeSchema,5\n");
    GuiRobot hands = new GuiRobot();
    RatingsDialog dialog = GuiRobot.onEdt(() -> new RatingsDialog(null, session));
    hands.show(dialog);
    JTable proposals =
        GuiRobot.named(dialog, "Proposals from what participants looked at", JTable.class);
    assertThat(GuiRobot.onEdt(proposals::isShowing)).isFalse();
    GuiRobot.onEdt(
        () -> {
          dialog.openLogs(List.of(folder.resolve("logs")));
          return true;
        });
    hands.await("the proposals", () -> proposals.getRowCount() == 12);
    hands.await("their table", proposals::isShowing);
    assertThat(GuiRobot.named(dialog, "Apply", JButton.class).isEnabled()).isFalse();
    assertThat(cell(proposals, 0, 7)).isEqualTo("inconsistent");
    String object = cell(proposals, 0, 1);
    hands.click(proposals, 0, GazeTableModel.ACCEPT);
    hands.await("the plan", GuiRobot.named(dialog, "Apply", JButton.class)::isEnabled);
    GuiRobot.picture(dialog.getContentPane(), "ratings-gaze", 1);

    GuiRobot.onEdt(
        () -> {
          dialog.open(ratings);
          return true;
        });
    hands.await("the ratings beside", () -> rated(proposals, "Switch_Object1").equals("6.00"));
    assertThat(GuiRobot.onEdt(() -> accepted(proposals, object))).isTrue();

    hands.click(GuiRobot.named(dialog, "Apply", JButton.class));
    hands.await("the end", () -> !dialog.isShowing());
    assertThat(session.document().history().names()).hasSize(1);
    assertThat(session.enrichment().switchesByName().get(object).choices().get(0).values())
        .satisfies(
            values -> {
              assertThat(values.schemas()).containsExactly("OfficeSchema");
              assertThat(values.type()).contains(ConsistencyType.INCONSISTENT);
            });
    session.document().history().undo();
    assertThat(session.document().text().toString()).isEqualTo(before);
  }

  private static String cell(JTable table, int row, int column) {
    return GuiRobot.onEdt(() -> String.valueOf(table.getValueAt(row, column)));
  }

  private static String rated(JTable table, String object) {
    return String.valueOf(table.getValueAt(row(table, object), 3));
  }

  private static boolean accepted(JTable table, String object) {
    return Boolean.TRUE.equals(table.getValueAt(row(table, object), GazeTableModel.ACCEPT));
  }

  private static int row(JTable table, String object) {
    for (int row = 0; row < table.getRowCount(); row++) {
      if (object.equals(table.getValueAt(row, 1))) {
        return row;
      }
    }
    throw new AssertionError(object + " is not in the table");
  }

  @Test
  void logsThatCannotBeReadAreSaid() throws IOException {
    TestSessions.theme(false);
    EnricherSession session = TestSessions.with(folder, TestSessions.object("Sink"));
    GuiRobot hands = new GuiRobot();
    RatingsDialog dialog = GuiRobot.onEdt(() -> new RatingsDialog(null, session));
    hands.show(dialog);
    Path none = Files.createDirectory(folder.resolve("none"));
    GuiRobot.onEdt(
        () -> {
          dialog.openLogs(List.of(none));
          return true;
        });
    javax.swing.JList<?> problems =
        GuiRobot.named(dialog, "Problems of the table", javax.swing.JList.class);
    hands.await("the problem", () -> problems.getModel().getSize() == 1);
    assertThat(GuiRobot.onEdt(() -> problems.getModel().getElementAt(0).toString()))
        .contains("no head logs in this folder");
    GuiRobot.onEdt(
        () -> {
          dialog.dispose();
          return true;
        });
  }
}
