package org.selectiverenderer.app.studies.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JTabbedPane;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.selectiverenderer.study.definition.StudyTemplate;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.testing.WindowFinder;
import org.selectiverenderer.testing.robot.DisplaySettling;
import org.selectiverenderer.testing.robot.GuiRobot;

/**
 * Pictures of the study window with an example study, for the manual: {@code docs/pictures.sh} runs
 * this at 200 %, so that letters are as wide as their windows think.
 */
@ShowsWindows
@EnabledIfSystemProperty(named = "sun.java2d.uiScale", matches = "2")
@Timeout(value = 240, unit = TimeUnit.SECONDS)
class StudyWindowPictures extends StudyWindowFixture {
  private static final int SCALE = 2;

  private JFrame window() throws IOException {
    Path study =
        StudyTemplate.copy(
            Path.of("docs/examples/quality-and-light"), folder.resolve("quality-and-light"));
    JFrame window = open(Optional.of(study));
    hands.await("the study", () -> window.getTitle().startsWith("Quality and light"));
    return window;
  }

  /** Takes a picture, in which folders are not those of the machine that draws it. */
  private void picture(JFrame window, String name) throws IOException {
    JLabel file = in(window, "file", JLabel.class);
    JTextArea messages = in(window, "live.messages", JTextArea.class);
    GuiRobot.onEdt(
        () -> {
          file.setText("/home/lab/quality-and-light/study.json");
          messages.setText(
              messages
                  .getText()
                  .replaceAll("(?m)^Picked up .*\\R", "")
                  .replace(folder.toString(), "/home/lab"));
          return true;
        });
    DisplaySettling.pause(1500);
    GuiRobot.picture(window.getContentPane(), name, SCALE);
  }

  @Test
  void plan() throws IOException {
    JFrame window = window();
    page(window, 1);
    assertThat(in(window, "tabs", JTabbedPane.class).isShowing()).isTrue();
    picture(window, "study-plan");
  }

  /** A simulated participant's session, some trials after its begin. */
  @Test
  void session() throws IOException {
    JFrame window = window();
    JCheckBox simulated = in(window, "session.unattended", JCheckBox.class);
    WindowFinder.click(hands, simulated, simulated::isSelected);
    JButton start = in(window, "session.start", JButton.class);
    JTextField command = in(window, "session.start.command", JTextField.class);
    assertThat(command.getText()).endsWith("--participant 001 --unattended");
    WindowFinder.click(hands, start, () -> !start.isEnabled());
    JLabel head = in(window, "live.head", JLabel.class);
    hands.await("the session", () -> !head.getText().isBlank());
    DisplaySettling.pause(25_000);
    picture(window, "study-session");
  }
}
