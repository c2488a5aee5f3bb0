package org.selectiverenderer.enricher.cost;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.EventQueue;
import java.awt.Point;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JTable;
import javax.swing.JTextField;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.authoring.enrichment.ChoiceMetadata;
import org.selectiverenderer.authoring.file.DocumentFile;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.enricher.robot.TestSessions;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.settings.EnricherSettings;
import org.selectiverenderer.enricher.task.TaskExecutor;
import org.selectiverenderer.schema.ConsistencyDegree;
import org.selectiverenderer.schema.ConsistencyType;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.testing.robot.GuiRobot;
import org.selectiverenderer.validation.CostBudget;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;

/** Polygons, limits and contributions beside the author's edits. */
@ShowsWindows
class CostPanelTest {
  private static final String SCENE =
      """
      <X3D version='4.0'><Scene>
      <Group DEF='Office'>
      <ProximitySensor DEF='DeskArea' size='2 2 2'>
        <MetadataSet containerField='metadata'>
          <MetadataString name='enterTimeSchema' value='"Desk"' containerField='value'/>
        </MetadataSet>
      </ProximitySensor>
      %s%s
      </Group>
      </Scene></X3D>
      """;

  @TempDir Path folder;
  private final GuiRobot hands = new GuiRobot();
  private final List<String> messages = new ArrayList<>();
  private final List<String> changes = new ArrayList<>();
  private JFrame frame;
  private CostPanel panel;
  private TaskExecutor tasks;

  /** An object of 12 triangles and of 2, of which nothing is said. */
  private static String object(String name) {
    return """
    <Switch DEF='Switch_%s' whichChoice='1'>
      <Shape><Box/></Shape>
      <Shape><IndexedFaceSet coordIndex='0 1 2 -1 0 2 3 -1'>
        <Coordinate point='0 0 0 1 0 0 1 1 0 0 1 0'/>
      </IndexedFaceSet></Shape>
    </Switch>
    """
        .formatted(name);
  }

  private EnricherSession show() throws IOException {
    Path file =
        Files.writeString(
            folder.resolve("scene.x3d"), SCENE.formatted(object("Cup"), object("Pan")));
    TestSessions.theme(false);
    tasks = new TaskExecutor(EventQueue::invokeLater);
    EnricherSession session =
        new EnricherSession(DocumentFile.open(file), NodeCatalogue.load(), tasks, messages::add);
    EnricherSettings settings = new EnricherSettings(folder.resolve("settings"));
    frame =
        GuiRobot.onEdt(
            () -> {
              JFrame made = new JFrame("cost");
              panel =
                  new CostPanel(
                      session,
                      new BudgetFileLocator(() -> file, settings, (read, found) -> read),
                      () -> changes.add("other"));
              made.setContentPane(panel);
              made.setSize(1100, 300);
              return made;
            });
    hands.show(frame);
    return session;
  }

  @AfterEach
  void close() {
    SwingUtilities.invokeLater(
        () -> {
          panel.dispose();
          frame.dispose();
          tasks.close();
        });
  }

  private static void describe(EnricherSession session, int object) {
    ChoiceMetadata desk =
        new ChoiceMetadata(
            Optional.of(ConsistencyType.INCONSISTENT),
            Optional.of(ConsistencyDegree.LOW),
            List.of("Desk"));
    GuiRobot.onEdt(
        () -> {
          session.perform(
              session.edits().choice(session.enrichment().switches().get(object), 0, desk));
          return true;
        });
  }

  private JTable table(String name) {
    return GuiRobot.named(frame.getContentPane(), name, JTable.class);
  }

  private static List<String> cells(JTable table, int column) {
    List<String> cells = new ArrayList<>();
    for (int row = 0; row < table.getRowCount(); row++) {
      cells.add(String.valueOf(table.getValueAt(row, column)));
    }
    return cells;
  }

  private static List<String> column(JTable table, int column) {
    return GuiRobot.onEdt(() -> cells(table, column));
  }

  private static int deskRow(JTable states) {
    return cells(states, StatesTableModel.STATE).indexOf("Desk");
  }

  @Test
  void aLimitIsSetKeptHeldAndBrokenAndTheCulpritFound() throws IOException {
    EnricherSession session = show();
    JTable states = table("Polygons by area and schemas");
    describe(session, 0);
    // The count before the object was described has the state already, of the whole scene.
    hands.await("the state", () -> cells(states, StatesTableModel.SCOPE).contains("Office"));
    assertThat(column(states, StatesTableModel.SCOPE)).contains("Office", "Whole scene");
    int desk = GuiRobot.onEdt(() -> deskRow(states));
    assertThat(column(states, StatesTableModel.POLYGONS).get(desk)).isEqualTo("14");

    GuiRobot.onEdt(
        () -> {
          states.setValueAt("1 5", desk, StatesTableModel.LIMIT);
          return true;
        });
    hands.await("the limit", () -> "15".equals(states.getValueAt(desk, StatesTableModel.LIMIT)));
    Path file = folder.resolve(BudgetFileLocator.NAME);
    EnricherSettings settings = new EnricherSettings(folder.resolve("settings"));
    assertThat(
            new BudgetFileLocator(
                    () -> folder.resolve("scene.x3d"), settings, (read, found) -> read)
                .settings(new ProblemCollector())
                .orElseThrow()
                .budgets())
        .containsExactly(new CostBudget("scene.x3d", "Office", List.of("Desk"), 15));
    assertThat(changes).containsExactly("other");

    describe(session, 1);
    hands.await("the warning", () -> !messages.isEmpty());
    assertThat(messages)
        .containsExactly("\u25b2 Office, Desk: 24 polygons now, 9 more than its limit of 15");
    assertThat(Files.readString(file)).contains("\"polygons\": 15");
    GuiRobot.picture(frame.getContentPane(), "cost-broken", 2);

    hands.click(states, desk, StatesTableModel.STATE);
    JTable objects = table("Polygons by object");
    assertThat(column(objects, ObjectsTableModel.POLYGONS)).containsExactly("12", "12");
    hands.click(objects, 1, ObjectsTableModel.OBJECT);
    assertThat(session.selection().orElseThrow().def()).contains("Switch_Pan");
    GuiRobot.onEdt(
        () -> {
          states.setValueAt("", desk, StatesTableModel.LIMIT);
          return true;
        });
    hands.await("no limit", () -> "".equals(states.getValueAt(desk, StatesTableModel.LIMIT)));
    assertThat(Files.readString(file)).doesNotContain("Desk");
  }

  @Test
  void limitsOfOtherFilesAreNotThisOnesAndThoseOfAllStayThoseOfAll() throws IOException {
    Path file =
        Files.writeString(
            folder.resolve(BudgetFileLocator.NAME),
            """
            {"budgets": [
              {"file": "other.x3d", "scope": "Office", "schemas": ["Desk"], "polygons": 1},
              {"scope": "Office", "polygons": 90}
            ]}
            """);
    EnricherSession session = show();
    describe(session, 0);
    JTable states = table("Polygons by area and schemas");
    hands.await("the limit", () -> cells(states, StatesTableModel.LIMIT).contains("90"));
    hands.await("the state", () -> officeDesk(states) >= 0);
    int desk = GuiRobot.onEdt(() -> officeDesk(states));
    assertThat(column(states, StatesTableModel.LIMIT)).doesNotContain("1");
    set(states, desk, "77");
    hands.await("its limit", () -> cells(states, StatesTableModel.LIMIT).contains("77"));
    set(states, GuiRobot.onEdt(() -> cells(states, StatesTableModel.LIMIT).indexOf("90")), "91");
    hands.await("the limit of all", () -> cells(states, StatesTableModel.LIMIT).contains("91"));
    assertThat(Files.readString(file))
        .contains("{\"file\": \"other.x3d\"", "\"polygons\": 1}")
        .contains("{\"scope\": \"Office\", \"polygons\": 91}")
        .contains("{\"file\": \"scene.x3d\", \"scope\": \"Office\"");
    assertThat(messages).isEmpty();
  }

  private static int officeDesk(JTable states) {
    for (int row = 0; row < states.getRowCount(); row++) {
      if ("Desk".equals(states.getValueAt(row, StatesTableModel.STATE))
          && "Office".equals(states.getValueAt(row, StatesTableModel.SCOPE))) {
        return row;
      }
    }
    return -1;
  }

  private static void set(JTable states, int row, String limit) {
    GuiRobot.onEdt(
        () -> {
          states.setValueAt(limit, row, StatesTableModel.LIMIT);
          return true;
        });
  }

  @Test
  void whereThereIsLittleRoomNamesStayReadableAndTheTablesScroll() throws IOException {
    show();
    GuiRobot.onEdt(
        () -> {
          frame.setSize(200, 300);
          frame.validate();
          return true;
        });
    for (String name : List.of("Polygons by area and schemas", "Polygons by object")) {
      JTable table = table(name);
      int letter = GuiRobot.onEdt(() -> table.getFontMetrics(table.getFont()).charWidth('n'));
      assertThat(GuiRobot.onEdt(() -> table.getColumnModel().getColumn(0).getWidth()))
          .as(name)
          .isGreaterThanOrEqualTo(8 * letter);
      assertThat(GuiRobot.onEdt(() -> table.getWidth() > table.getParent().getWidth()))
          .as("scrolls: " + name)
          .isTrue();
    }
  }

  @Test
  void tablesStandOneAboveTheOtherBeforeAnythingHasToScrollSideways() throws IOException {
    show();
    GuiRobot.onEdt(
        () -> {
          frame.setSize(760, 400);
          frame.validate();
          return true;
        });
    JTable states = table("Polygons by area and schemas");
    JTable objects = table("Polygons by object");
    hands.await("the other order", () -> below(states, objects));
    for (JTable table : List.of(states, objects)) {
      assertThat(GuiRobot.onEdt(() -> table.getWidth() <= table.getParent().getWidth())).isTrue();
    }
    GuiRobot.onEdt(
        () -> {
          frame.setSize(1400, 300);
          frame.validate();
          return true;
        });
    hands.await("side by side", () -> !below(states, objects));
  }

  private boolean below(JTable states, JTable objects) {
    Point other = SwingUtilities.convertPoint(objects.getParent(), 0, 0, panel);
    Point first = SwingUtilities.convertPoint(states.getParent(), 0, 0, panel);
    return other.y > first.y;
  }

  @Test
  void aCountThatArrivesLeavesTheLimitThatIsBeingWritten() throws IOException {
    EnricherSession session = show();
    JTable states = table("Polygons by area and schemas");
    describe(session, 0);
    hands.await("the state", () -> deskRow(states) >= 0);
    GuiRobot.onEdt(
        () -> {
          states.editCellAt(deskRow(states), StatesTableModel.LIMIT);
          ((JTextField) states.getEditorComponent()).setText("7");
          return true;
        });
    describe(session, 1);
    hands.await("another count", () -> panel.waits());
    assertThat(GuiRobot.onEdt(() -> ((JTextField) states.getEditorComponent()).getText()))
        .isEqualTo("7");
    GuiRobot.onEdt(() -> states.getCellEditor().stopCellEditing());
    // It is the limit of the row that was written in, wherever the other count has that row.
    hands.await("the limit", () -> cells(states, StatesTableModel.LIMIT).contains("7"));
    assertThat(GuiRobot.onEdt(() -> panel.waits())).isFalse();
    assertThat(column(states, StatesTableModel.POLYGONS)).contains("24");
  }

  @Test
  void whileNoObjectIsEnrichedThePanelSaysThatWhatTheSceneShowsIsCounted() throws IOException {
    EnricherSession session = show();
    JLabel rest = GuiRobot.named(panel, "Polygons of objects without versions", JLabel.class);
    hands.await("the sentence", () -> rest.getText().startsWith("No object is enriched yet"));
    describe(session, 0);
    JTable states = table("Polygons by area and schemas");
    hands.await("the state", () -> deskRow(states) >= 0);
    hands.await("its end", () -> !rest.getText().startsWith("No object is enriched yet"));
  }

  @Test
  void aFaultOfTheSettingsFileIsSaidAndTheFileStays() throws IOException {
    Path file = Files.writeString(folder.resolve(BudgetFileLocator.NAME), "{\"budget\": []}");
    EnricherSession session = show();
    describe(session, 0);
    JTable states = table("Polygons by area and schemas");
    hands.await("the state", () -> deskRow(states) >= 0);
    GuiRobot.onEdt(
        () -> {
          states.setValueAt("5", deskRow(states), StatesTableModel.LIMIT);
          return true;
        });
    hands.await("the reason", () -> !messages.isEmpty());
    assertThat(messages.get(0))
        .contains("did you mean \"budgets\"")
        .contains("the budget is not saved");
    assertThat(Files.readString(file)).isEqualTo("{\"budget\": []}");
  }
}
