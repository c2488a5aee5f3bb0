package org.selectiverenderer.enricher.component;

import static org.assertj.core.api.Assertions.assertThat;
import static org.selectiverenderer.enricher.EventThread.edt;
import static org.selectiverenderer.enricher.EventThread.get;

import java.awt.AWTException;
import java.awt.Robot;
import java.awt.event.ActionEvent;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Function;
import javax.swing.AbstractAction;
import javax.swing.JDialog;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.selectiverenderer.enricher.robot.TestSessions;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.testing.robot.GuiRobot;

/** Dialogs under the hands of somebody who types before they are on the screen. */
@ShowsWindows
@Timeout(value = 120, unit = TimeUnit.SECONDS)
class InputDialogTest {
  private static final int DIALOGS = 200;

  /** Fewer dialogs will do on a machine that does not show as many in this time. */
  private static final long LONGEST = TimeUnit.SECONDS.toNanos(30);

  private static final int FEWEST = 10;
  private static final String LETTERS = "abcdefghij";

  private final GuiRobot hands = new GuiRobot();
  private final JFrame window = get(() -> new JFrame("Below"));
  private final JTextField below = get(JTextField::new);
  private Optional<Process> manager = Optional.empty();
  private Robot robot;

  @BeforeEach
  void show() throws AWTException {
    robot = new Robot();
    try {
      manager = Optional.of(new ProcessBuilder("openbox").start()); // ends where another one runs
    } catch (IOException e) {
      manager = Optional.empty(); // not installed
    }
    TestSessions.theme(false);
    edt(
        () -> {
          below.getAccessibleContext().setAccessibleName("Below");
          window.getContentPane().add(below);
          window.setBounds(20, 20, 500, 300);
        });
    hands.show(window);
    hands.click(below);
  }

  @AfterEach
  void close() throws InterruptedException {
    edt(window::dispose);
    if (manager.isPresent()) {
      manager.get().destroy();
      manager.get().waitFor();
    }
  }

  private void stroke(int key) {
    robot.keyPress(key);
    robot.keyRelease(key);
  }

  private void type(String letters) {
    letters.chars().forEach(letter -> stroke(KeyEvent.getExtendedKeyCodeForChar(letter)));
  }

  private CompletableFuture<Optional<String>> ask(Function<String, Optional<String>> complaint) {
    CompletableFuture<Optional<String>> answer = new CompletableFuture<>();
    SwingUtilities.invokeLater(
        () ->
            answer.complete(
                InputDialog.ask(window, "Rename", "Name (DEF)", "Proposal", complaint)));
    return answer;
  }

  /** The answer; of a dialog that never got the Enter, that it is still open. */
  private static String said(CompletableFuture<Optional<String>> answer)
      throws InterruptedException, ExecutionException {
    try {
      return answer.get(10, TimeUnit.SECONDS).orElse("(cancelled)");
    } catch (TimeoutException e) {
      edt(
          () -> {
            for (java.awt.Window each : java.awt.Window.getWindows()) {
              if (each instanceof JDialog) {
                each.dispose();
              }
            }
          });
      return "(open)";
    }
  }

  @Test
  void noLetterTypedSinceADialogWasAskedForIsLost()
      throws InterruptedException, ExecutionException {
    List<String> wrong = new ArrayList<>();
    long begin = System.nanoTime();
    int dialogs = 0;
    while (dialogs < DIALOGS && (dialogs < FEWEST || System.nanoTime() - begin < LONGEST)) {
      CompletableFuture<Optional<String>> answer = ask(name -> Optional.empty());
      type(LETTERS);
      stroke(KeyEvent.VK_ENTER);
      String said = said(answer);
      if (!said.equals(LETTERS)) {
        wrong.add(dialogs + ": " + said);
      }
      dialogs++;
      if (!GuiRobot.has(below::isFocusOwner)) {
        hands.click(below); // without a window manager nobody gives the keyboard back
      }
    }
    assertThat(wrong).as("of " + dialogs + " dialogs").isEmpty();
    String under = get(below::getText);
    assertThat(under).as("typed into the window below").isEmpty();
  }

  @Test
  void whatIsInvalidIsSaidInTheDialogWhichStays() throws InterruptedException, ExecutionException {
    CompletableFuture<Optional<String>> answer =
        ask(name -> name.equals("ab") ? Optional.of("<html>ab is taken") : Optional.empty());
    type("ab");
    JDialog dialog = hands.dialog(JDialog.class);
    JLabel complaint = GuiRobot.named(dialog, " ", JLabel.class);
    stroke(KeyEvent.VK_ENTER);
    hands.await("the complaint", () -> complaint.getText().contains("ab is taken"));
    GuiRobot.picture(dialog.getContentPane(), "input-dialog", 1);
    type("c");
    stroke(KeyEvent.VK_ENTER);
    assertThat(said(answer)).isEqualTo("abc");
  }

  @Test
  void escapeCancelsHoweverEarlyItIsTyped() throws InterruptedException, ExecutionException {
    CompletableFuture<Optional<String>> answer = ask(name -> Optional.empty());
    type("ab");
    stroke(KeyEvent.VK_ESCAPE);
    assertThat(said(answer)).isEqualTo("(cancelled)");
  }

  @Test
  void theKeyThatOpensADialogIsNotTypedIntoIt() throws InterruptedException, ExecutionException {
    CompletableFuture<Optional<String>> answer = new CompletableFuture<>();
    edt(
        () -> {
          below.getInputMap().put(KeyStroke.getKeyStroke("N"), "ask");
          below
              .getActionMap()
              .put(
                  "ask",
                  new AbstractAction() {
                    private static final long serialVersionUID = 1L;

                    @Override
                    public void actionPerformed(ActionEvent event) {
                      answer.complete(
                          InputDialog.ask(window, "New", "Name", "", name -> Optional.empty()));
                    }
                  });
        });
    type("nab");
    stroke(KeyEvent.VK_ENTER);
    assertThat(said(answer)).isEqualTo("ab");
  }
}
