package org.selectiverenderer.swing;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.Container;
import java.awt.Window;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import javax.swing.JButton;
import javax.swing.JDialog;
import javax.swing.JTextArea;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.testing.Eventually;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.testing.WindowFinder;
import org.selectiverenderer.testing.robot.GuiRobot;

@ShowsWindows
class TrustDialogTest {
  private static final TrustDialog.Words WORDS =
      new TrustDialog.Words("Title", "study.json asks:", "Agree only if ...", "Agree", "Cancel");

  @AfterEach
  void leave() {
    WindowFinder.closeAll();
  }

  private static <C> List<C> parts(Container in, Class<C> kind) {
    List<C> found = new ArrayList<>();
    for (Component part : in.getComponents()) {
      if (kind.isInstance(part)) {
        found.add(kind.cast(part));
      }
      if (part instanceof Container container) {
        found.addAll(parts(container, kind));
      }
    }
    return found;
  }

  private static JDialog shown() {
    List<JDialog> found = new ArrayList<>();
    Eventually.await(
        "the dialog",
        () -> {
          for (Window window : Window.getWindows()) {
            if (window instanceof JDialog dialog && window.isShowing()) {
              found.add(dialog);
              return true;
            }
          }
          return false;
        });
    return found.get(0);
  }

  private static boolean answered(String button) throws Exception {
    CompletableFuture<Optional<Boolean>> answer =
        CompletableFuture.supplyAsync(
            () ->
                TrustDialog.ask(
                    Optional.empty(), WORDS, List.of("<html>\"allow\" /", "\"tracker\" tcp:a:1")));
    JDialog dialog = shown();
    List<String> texts =
        GuiRobot.onEdt(
            () -> parts(dialog, JTextArea.class).stream().map(JTextArea::getText).toList());
    assertThat(String.join("|", texts))
        .contains("study.json asks:", "<html>\"allow\" /", "\"tracker\" tcp:a:1", "Agree only if");
    GuiRobot.onEdt(
        () -> {
          assertThat(dialog.getRootPane().getDefaultButton().getText()).isEqualTo("Cancel");
          parts(dialog, JButton.class).stream()
              .filter(each -> each.getText().equals(button))
              .findFirst()
              .orElseThrow()
              .doClick();
          return true;
        });
    return answer.get(20, TimeUnit.SECONDS).orElseThrow();
  }

  @Test
  void showsAllThatIsAskedAndReturnsTheAnswer() throws Exception {
    assertThat(answered("Agree")).isTrue();
    assertThat(answered("Cancel")).isFalse();
  }
}
