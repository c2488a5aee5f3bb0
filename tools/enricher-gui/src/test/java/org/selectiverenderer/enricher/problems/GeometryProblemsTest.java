package org.selectiverenderer.enricher.problems;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicReference;
import java.util.stream.IntStream;
import javax.swing.JButton;
import javax.swing.JFrame;
import javax.swing.JTable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.authoring.geometry.RepeatedPointsCheck;
import org.selectiverenderer.enricher.robot.TestSessions;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.testing.robot.GuiRobot;
import org.selectiverenderer.validation.SourceFile;
import org.selectiverenderer.validation.ValidationSettings;
import org.selectiverenderer.validation.run.RuleCatalogue;
import org.selectiverenderer.validation.run.Validator;

/** Findings about geometry are repaired or accepted from the list of problems. */
@ShowsWindows
class GeometryProblemsTest {
  private static final String MESH =
      """
        <Shape>
          <IndexedFaceSet coordIndex='0 1 1 -1 0 1 2 -1'>
            <Coordinate point='0 0 0 1 0 0 0 1 0'/>
            <Normal vector='0 0 3 0 0 1 0 0 1'/>
          </IndexedFaceSet>
        </Shape>
      """;

  @TempDir Path folder;

  @Test
  void normalsAreNormalizedAndEmptyFacesAcceptedAndTheValidatorAgrees() throws IOException {
    TestSessions.theme(false);
    EnricherSession session = TestSessions.with(folder, MESH);
    RuleCatalogue rules = RuleCatalogue.standard();
    ProblemsPanel panel =
        GuiRobot.onEdt(
            () ->
                new ProblemsPanel(
                    session,
                    List.of(
                        new ValidatorCheck(
                            () -> session.file().path(),
                            rules,
                            problems -> Optional.of(ValidationSettings.standard())))));
    GuiRobot hands = new GuiRobot();
    JFrame frame =
        GuiRobot.onEdt(
            () -> {
              JFrame made = new JFrame();
              made.add(panel);
              made.setSize(1000, 300);
              return made;
            });
    hands.show(frame);
    JTable table = GuiRobot.named(frame, "Problems of the scene", JTable.class);
    hands.await("both findings", () -> row(table, "SR203") >= 0 && row(table, "SR205") >= 0);

    GuiRobot.onEdt(
        () -> {
          int row = row(table, "SR205");
          table.setRowSelectionInterval(row, row);
          return null;
        });
    GuiRobot.picture(panel, "problems-geometry", 1);
    hands.click(GuiRobot.named(frame, "Normalize the normals", JButton.class));
    hands.await("the repair", () -> row(table, "SR205") < 0);
    assertThat(session.document().text().toString()).contains("vector='0 0 1 0 0 1 0 0 1'");

    GuiRobot.onEdt(
        () -> {
          int row = row(table, "SR203");
          table.setRowSelectionInterval(row, row);
          return null;
        });
    hands.click(GuiRobot.named(frame, "Ignore This Here", JButton.class));
    hands.await("the acceptance", () -> row(table, "SR203") < 0);
    Path scene = session.file().path();
    assertThat(
            new Validator(rules, ValidationSettings.standard(), folder)
                .validate(
                    List.of(
                        SourceFile.of(scene, "scene.x3d", session.document().snapshot().bytes())))
                .findings())
        .noneMatch(finding -> finding.rule().id().startsWith("SR20"));
    GuiRobot.onEdt(
        () -> {
          session.document().history().undo();
          return null;
        });
    hands.await("the finding again", () -> row(table, "SR203") >= 0);
    GuiRobot.onEdt(
        () -> {
          panel.dispose();
          frame.dispose();
          return null;
        });
  }

  @Test
  void equalPointsAreWeldedFromTheList() throws IOException {
    TestSessions.theme(false);
    EnricherSession session =
        TestSessions.with(
            folder,
            """
              <Shape>
                <IndexedFaceSet coordIndex='0 1 2 -1 3 4 5 -1'>
                  <Coordinate point='0 0 0 1 0 0 0 1 0 0 1 0 1 0 0 1 1 0'/>
                </IndexedFaceSet>
              </Shape>
            """);
    String before = session.document().text().toString();
    ProblemsPanel panel =
        GuiRobot.onEdt(() -> new ProblemsPanel(session, List.of(new RepeatedPointsCheck())));
    GuiRobot hands = new GuiRobot();
    JFrame frame =
        GuiRobot.onEdt(
            () -> {
              JFrame made = new JFrame();
              made.add(panel);
              made.setSize(1000, 300);
              return made;
            });
    hands.show(frame);
    JTable table = GuiRobot.named(frame, "Problems of the scene", JTable.class);
    String finding = "2 of 6 points of IndexedFaceSet repeat another";
    hands.await("the finding", () -> row(table, finding) >= 0);
    GuiRobot.onEdt(
        () -> {
          int row = row(table, finding);
          table.setRowSelectionInterval(row, row);
          return null;
        });
    GuiRobot.picture(panel, "problems-weld", 1);
    hands.click(GuiRobot.named(frame, "Weld the points", JButton.class));
    hands.await("the repair", () -> row(table, finding) < 0);
    assertThat(session.document().text().toString())
        .contains("coordIndex='0 1 2 -1 2 1 3 -1'")
        .contains("point='0 0 0 1 0 0 0 1 0 1 1 0'");
    assertThat(session.document().history().names())
        .containsExactly("Weld 2 points of IndexedFaceSet");
    GuiRobot.onEdt(
        () -> {
          session.document().history().undo();
          panel.dispose();
          frame.dispose();
          return null;
        });
    assertThat(session.document().text().toString()).isEqualTo(before);
  }

  private static final String REPEATED =
      """
        <Shape>
          <IndexedFaceSet coordIndex='0 1 2 -1 3 4 5 -1'>
            <Coordinate point='0 0 0 1 0 0 0 1 0 0 1 0 1 0 0 1 1 0'/>
          </IndexedFaceSet>
        </Shape>
      """;

  @Test
  void manyMeshesAreOneRowThatIsIgnoredOrWeldedAtOnce() throws IOException {
    TestSessions.theme(false);
    EnricherSession session = TestSessions.with(folder, REPEATED.repeat(40));
    String before = session.document().text().toString();
    RuleCatalogue rules = RuleCatalogue.standard();
    AtomicReference<ValidationSettings> settings =
        new AtomicReference<>(ValidationSettings.standard());
    ValidatorCheck validator =
        new ValidatorCheck(
            () -> session.file().path(), rules, problems -> Optional.of(settings.get()));
    ProblemsPanel panel =
        GuiRobot.onEdt(
            () ->
                new ProblemsPanel(
                    session,
                    List.of(
                        validator,
                        validator.graded(RepeatedPointsCheck.RULE, new RepeatedPointsCheck()))));
    GuiRobot hands = new GuiRobot();
    JFrame frame =
        GuiRobot.onEdt(
            () -> {
              JFrame made = new JFrame();
              made.add(panel);
              made.setSize(1000, 300);
              return made;
            });
    hands.show(frame);
    JTable table = GuiRobot.named(frame, "Problems of the scene", JTable.class);
    hands.await("the finding", () -> row(table, "SR208") >= 0);
    assertThat(GuiRobot.onEdt(() -> rows(table, "SR208"))).isEqualTo(1);
    select(table, "40 meshes hold 80 repeated points");
    GuiRobot.picture(panel, "problems-weld-all", 1);

    hands.click(GuiRobot.named(frame, "Ignore This Here", JButton.class));
    hands.await("the acceptance", () -> row(table, "SR208") < 0);
    Path scene = session.file().path();
    assertThat(
            new Validator(rules, ValidationSettings.standard(), folder)
                .validate(
                    List.of(
                        SourceFile.of(scene, "scene.x3d", session.document().snapshot().bytes())))
                .findings())
        .as("the validator knows the rule of the comment")
        .noneMatch(finding -> finding.rule().id().startsWith("SR0"));
    GuiRobot.onEdt(
        () -> {
          session.document().history().undo();
          return null;
        });
    hands.await("the finding again", () -> row(table, "SR208") >= 0);

    settings.set(ValidationSettings.standard().ignoring(Set.of("SR208")));
    GuiRobot.onEdt(
        () -> {
          panel.checkAgain();
          return null;
        });
    hands.await("no finding that the settings ignore", () -> row(table, "SR208") < 0);
    settings.set(ValidationSettings.standard());
    GuiRobot.onEdt(
        () -> {
          panel.checkAgain();
          return null;
        });
    hands.await("the finding once more", () -> row(table, "SR208") >= 0);

    select(table, "40 meshes hold 80 repeated points");
    hands.click(GuiRobot.named(frame, "Weld All", JButton.class));
    hands.await("the repair", () -> row(table, "SR208") < 0);
    assertThat(session.document().history().names())
        .containsExactly("Weld all: 80 points of 40 meshes");
    GuiRobot.onEdt(
        () -> {
          session.document().history().undo();
          panel.dispose();
          frame.dispose();
          return null;
        });
    assertThat(session.document().text().toString()).isEqualTo(before);
  }

  private static void select(JTable table, String words) {
    GuiRobot.onEdt(
        () -> {
          int row = row(table, words);
          table.setRowSelectionInterval(row, row);
          return null;
        });
  }

  private static long rows(JTable table, String words) {
    return IntStream.range(0, table.getRowCount())
        .filter(
            row ->
                String.valueOf(table.getValueAt(row, ProblemsTableModel.MESSAGE)).contains(words))
        .count();
  }

  private static int row(JTable table, String rule) {
    return IntStream.range(0, table.getRowCount())
        .filter(
            row -> String.valueOf(table.getValueAt(row, ProblemsTableModel.MESSAGE)).contains(rule))
        .findFirst()
        .orElse(-1);
  }
}
