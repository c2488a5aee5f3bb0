package org.selectiverenderer.enricher.component;

import static org.assertj.core.api.Assertions.assertThat;
import static org.selectiverenderer.enricher.EventThread.edt;
import static org.selectiverenderer.enricher.EventThread.get;

import java.awt.AWTException;
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
import javax.swing.JLabel;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.selectiverenderer.enricher.robot.FastTypist;
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

  private FastTypist typist;

  @BeforeEach
  void show() throws AWTException, IOException {
    typist = new FastTypist();
  }

  @AfterEach
  void close() {
    typist.close();
  }

  private CompletableFuture<Optional<String>> ask(Function<String, Optional<String>> complaint) {
    CompletableFuture<Optional<String>> answer = new CompletableFuture<>();
    SwingUtilities.invokeLater(
        () ->
            answer.complete(
                InputDialog.ask(typist.window(), "Rename", "Name (DEF)", "Proposal", complaint)));
    return answer;
  }

  /** The answer; of a dialog that never got the Enter, that it is still open. */
  private static String said(CompletableFuture<Optional<String>> answer)
      throws InterruptedException, ExecutionException {
    try {
      return answer.get(10, TimeUnit.SECONDS).orElse("(cancelled)");
    } catch (TimeoutException e) {
      FastTypist.closeDialogs();
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
      typist.type(LETTERS);
      typist.stroke(KeyEvent.VK_ENTER);
      String said = said(answer);
      if (!said.equals(LETTERS)) {
        wrong.add(dialogs + ": " + said);
      }
      dialogs++;
      typist.goBack();
    }
    assertThat(wrong).as("of " + dialogs + " dialogs").isEmpty();
    String under = get(typist.below()::getText);
    assertThat(under).as("typed into the window below").isEmpty();
  }

  @Test
  void whatIsInvalidIsSaidInTheDialogWhichStays() throws InterruptedException, ExecutionException {
    CompletableFuture<Optional<String>> answer =
        ask(name -> name.equals("ab") ? Optional.of("<html>ab is taken") : Optional.empty());
    typist.type("ab");
    GuiRobot hands = new GuiRobot();
    JDialog dialog = hands.dialog(JDialog.class);
    JLabel complaint = GuiRobot.named(dialog, " ", JLabel.class);
    typist.stroke(KeyEvent.VK_ENTER);
    hands.await("the complaint", () -> complaint.getText().contains("ab is taken"));
    GuiRobot.picture(dialog.getContentPane(), "input-dialog", 1);
    typist.type("c");
    typist.stroke(KeyEvent.VK_ENTER);
    assertThat(said(answer)).isEqualTo("abc");
  }

  @Test
  void escapeCancelsHoweverEarlyItIsTyped() throws InterruptedException, ExecutionException {
    CompletableFuture<Optional<String>> answer = ask(name -> Optional.empty());
    typist.type("ab");
    typist.stroke(KeyEvent.VK_ESCAPE);
    assertThat(said(answer)).isEqualTo("(cancelled)");
  }

  @Test
  void theKeyThatOpensADialogIsNotTypedIntoIt() throws InterruptedException, ExecutionException {
    CompletableFuture<Optional<String>> answer = new CompletableFuture<>();
    edt(
        () -> {
          JTextField below = typist.below();
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
                          InputDialog.ask(
                              typist.window(), "New", "Name", "", name -> Optional.empty()));
                    }
                  });
        });
    typist.type("nab");
    typist.stroke(KeyEvent.VK_ENTER);
    assertThat(said(answer)).isEqualTo("ab");
  }
}
