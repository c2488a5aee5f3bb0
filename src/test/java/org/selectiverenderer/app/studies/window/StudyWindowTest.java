package org.selectiverenderer.app.studies.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JDialog;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JTable;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.selectiverenderer.app.studies.SmallStudy;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.testing.WindowFinder;
import org.selectiverenderer.testing.robot.GuiRobot;

/** The study window, driven as an experimenter drives it. */
@ShowsWindows
@Timeout(value = 240, unit = TimeUnit.SECONDS)
class StudyWindowTest extends StudyWindowFixture {
  @Test
  void withoutAStudyItSaysWhatToDoAndRemembersWhatWasOpened() throws IOException {
    JFrame window = open(Optional.empty());
    JLabel head = in(window, "start.head", JLabel.class);
    hands.await("the empty list", () -> head.getText().startsWith("No study was opened yet"));
    assertThat(in(window, "start.again", JButton.class).isEnabled()).isFalse();
    WindowFinder.close(window);
    hands.await("the end", () -> closed.getCount() == 0);

    Path study = SmallStudy.write(folder.resolve("study"));
    JFrame opened = open(study, "Small study");
    JButton back = in(opened, "back", JButton.class);
    JList<?> recent = in(opened, "start.recent", JList.class);
    WindowFinder.click(hands, back, () -> recent.getModel().getSize() == 1);
    assertThat(recent.getModel().getElementAt(0)).isEqualTo(study.toAbsolutePath());
  }

  @Test
  void aStudyThatCannotBeReadIsExplainedInTheWindow() throws IOException {
    Path study = SmallStudy.write(folder.resolve("study"));
    Files.writeString(study, "{\"name\": 3");
    JFrame window = open(Optional.of(study));
    JTextArea said = in(window, "said", JTextArea.class);
    hands.await("the reason", () -> said.getText().contains("cannot be opened"));
    assertThat(said.getText()).contains("study.json:1");
    assertThat(said.isShowing()).isTrue();
  }

  @Test
  void aSessionIsStartedFollowedAndCounted() throws IOException {
    Path study = SmallStudy.write(folder.resolve("study"));
    JFrame window = open(study, "Small study");
    assertThat(in(window, "session.next", JLabel.class).getText()).startsWith("Place 1 of 4");
    JTextField id = in(window, "session.id", JTextField.class);
    assertThat(id.getText()).isEqualTo("001");
    JTextField command = in(window, "session.start.command", JTextField.class);
    assertThat(command.getText()).contains("experiment run").endsWith("--participant 001");

    JCheckBox simulated = in(window, "session.unattended", JCheckBox.class);
    WindowFinder.click(hands, simulated, simulated::isSelected);
    assertThat(command.getText()).endsWith("--participant 001 --unattended");
    JButton start = in(window, "session.start", JButton.class);
    JLabel head = in(window, "live.head", JLabel.class);
    WindowFinder.click(hands, start, () -> !start.isEnabled());
    hands.await("the end of the session", () -> head.getText().endsWith("is finished."));
    assertThat(in(window, "live.state", JLabel.class).getText()).contains("simulated");
    hands.await("the next id", () -> id.getText().equals("002") && start.isEnabled());
    JLabel next = in(window, "session.next", JLabel.class);
    hands.await("the next place", () -> next.getText().startsWith("Place 2 of 4"));

    page(window, 2);
    JTable sessions = in(window, "sessions", JTable.class);
    assertThat(sessions.getRowCount()).isEqualTo(1);
    assertThat(sessions.getValueAt(0, 0)).isEqualTo("001");
    hands.await("the finished session", () -> "finished".equals(sessions.getValueAt(0, 3)));
    assertThat(in(window, "sessions.summary", JLabel.class).getText()).startsWith("1 of 4");

    page(window, 4);
    JButton collect = in(window, "results.collect", JButton.class);
    JTextArea told = in(window, "results.told", JTextArea.class);
    JList<?> files = in(window, "results.files", JList.class);
    WindowFinder.click(
        hands, collect, () -> !collect.isEnabled() || files.getModel().getSize() > 0);
    hands.await("the tables", () -> files.getModel().getSize() > 0);
    assertThat(study.resolveSibling("results/responses.csv")).isRegularFile();
    assertThat(told.getText()).contains("collected: ");
  }

  @Test
  void anIdThatResemblesAnotherIsAskedAbout() throws IOException {
    Path study = SmallStudy.write(folder.resolve("study"));
    Path begun = Files.createDirectories(folder.resolve("study/sub-001/ses-01"));
    Files.writeString(begun.resolve("events.jsonl"), "");
    JFrame window = open(study, "Small study");
    JTextField id = in(window, "session.id", JTextField.class);
    GuiRobot.onEdt(
        () -> {
          id.setText("1");
          return true;
        });
    assertThat(in(window, "session.verdict", JLabel.class).getText())
        .isEqualTo("New, but resembles 001.");
    hands.click(in(window, "session.start", JButton.class));
    WindowFinder.answerDialog(hands, "No");
    assertThat(folder.resolve("study/sub-1")).doesNotExist();
    GuiRobot.onEdt(
        () -> {
          id.setText("a b");
          return true;
        });
    assertThat(in(window, "session.start", JButton.class).isEnabled()).isFalse();
    assertThat(in(window, "session.start.command", JTextField.class).getText()).isEmpty();
  }

  @Test
  void aBlindStudyHidesGroupsUntilTheyAreAskedFor() throws IOException {
    Path study = SmallStudy.write(folder.resolve("study"), true);
    JFrame window = open(study, "Small study");
    assertThat(in(window, "session.next", JLabel.class).getText()).contains("hidden");
    page(window, 1);
    JTable plan = in(window, "plan", JTable.class);
    JButton page = in(window, "plan.page", JButton.class);
    assertThat(plan.getValueAt(0, 2)).isEqualTo("hidden");
    assertThat(page.isEnabled()).isFalse();
    JCheckBox show = in(window, "plan.showcondition", JCheckBox.class);
    WindowFinder.click(hands, show, show::isSelected);
    assertThat(plan.getValueAt(0, 2)).isIn("high", "selective");
    assertThat(page.isEnabled()).isTrue();
  }

  @Test
  void theCheckSaysWhatItFinds() throws IOException {
    Path study = SmallStudy.write(folder.resolve("study"));
    JFrame window = open(study, "Small study");
    page(window, 3);
    JLabel verdict = in(window, "check.verdict", JLabel.class);
    JButton check = in(window, "check.run", JButton.class);
    JTextArea report = in(window, "check.report", JTextArea.class);
    WindowFinder.click(hands, check, () -> !verdict.getText().contains("not checked"));
    hands.await("the report", () -> report.getText().contains("a session takes about"));
    // What is wrong by now is found, too.
    Files.delete(folder.resolve("study/items.csv"));
    JTable findings = in(window, "findings", JTable.class);
    WindowFinder.click(hands, check, () -> findings.getRowCount() > 0);
    assertThat(findings.getValueAt(0, 0)).isEqualTo("error");
  }

  @Test
  void aNewStudyIsMadeAndOpened() {
    JFrame window = open(Optional.empty());
    hands.click(in(window, "start.new", JButton.class));
    JDialog dialog = hands.dialog(JDialog.class);
    JButton create = in(dialog, "new.create", JButton.class);
    assertThat(create.isEnabled()).isFalse();
    Path made = folder.resolve("made");
    JTextField place = in(dialog, "new.folder", JTextField.class);
    JTextField scene = in(dialog, "new.scene", JTextField.class);
    GuiRobot.onEdt(
        () -> {
          place.setText(made.toString());
          scene.setText(folder.resolve("none.x3d").toString());
          return true;
        });
    JTextArea fault = in(dialog, "new.fault", JTextArea.class);
    WindowFinder.click(hands, create, () -> fault.getText().contains("there is no scene"));
    GuiRobot.onEdt(
        () -> {
          scene.setText(Path.of("scenes/apartment.x3d").toAbsolutePath().toString());
          return true;
        });
    WindowFinder.click(hands, create, () -> !create.isEnabled() || !dialog.isShowing());
    hands.await("a question or the study", () -> WindowFinder.asking() || !dialog.isShowing());
    hands.await("the file", () -> Files.isRegularFile(made.resolve("study.json")));
  }
}
