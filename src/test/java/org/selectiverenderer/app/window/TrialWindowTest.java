package org.selectiverenderer.app.window;

import static org.assertj.core.api.Assertions.assertThat;

import com.formdev.flatlaf.FlatLightLaf;
import java.awt.Component;
import java.awt.Container;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.FutureTask;
import javax.swing.JButton;
import javax.swing.JFrame;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.study.questionnaire.ParticipantMessages;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.testing.WindowFinder;
import org.selectiverenderer.testing.robot.DisplaySettling;
import org.selectiverenderer.testing.robot.GuiRobot;

@ShowsWindows
class TrialWindowTest {
  @TempDir private Path folder;
  private final GuiRobot hands = new GuiRobot();

  @BeforeEach
  void look() {
    WindowFinder.closeAll();
    GuiRobot.onEdt(FlatLightLaf::setup);
  }

  @AfterEach
  void closeAll() {
    WindowFinder.closeAll();
  }

  private static TrialPage page(List<String> names) {
    BufferedImage picture = new BufferedImage(120, 120, BufferedImage.TYPE_INT_RGB);
    return new TrialPage(
        "Which?",
        "Keys",
        "Trial 1",
        names.isEmpty() ? List.of(picture, picture, picture) : List.of(picture),
        "original",
        names,
        names.isEmpty() ? "" : "none of them");
  }

  private FutureTask<Optional<TrialWindow.Reply>> asking(TrialPage page) throws IOException {
    ParticipantMessages wording =
        ParticipantMessages.of("en", folder, new ProblemCollector()).orElseThrow();
    return WindowFinder.asking(
        () -> {
          TrialWindow window = TrialWindow.open(wording, "Pilot");
          return window.introduce("Which?", "Look at the pictures.")
              ? window.ask(page)
              : Optional.empty();
        });
  }

  private JFrame begun() {
    JFrame frame = WindowFinder.named(hands, "trial");
    JButton begin = GuiRobot.named(frame, "Begin", JButton.class);
    WindowFinder.click(hands, begin, () -> !begin.isShowing());
    hands.await("the pictures", () -> shows(frame, "picture-1"));
    DisplaySettling.awaitWindow();
    return frame;
  }

  private static boolean shows(Container in, String name) {
    for (Component part : in.getComponents()) {
      if (name.equals(part.getName()) && part.isShowing()
          || part instanceof Container inner && shows(inner, name)) {
        return true;
      }
    }
    return false;
  }

  @Test
  void anArrowKeyAnswersAPairWithItsTime() throws IOException {
    FutureTask<Optional<TrialWindow.Reply>> asked = asking(page(List.of()));
    begun();
    hands.press(KeyEvent.VK_1); // Means nothing here.
    hands.press(KeyEvent.VK_RIGHT);

    TrialWindow.Reply reply = WindowFinder.answer(asked).orElseThrow();

    assertThat(reply.choice()).isEqualTo(1);
    assertThat(reply.ms()).isPositive();
  }

  @Test
  void aNumberNamesAnObjectAndZeroNone() throws IOException {
    FutureTask<Optional<TrialWindow.Reply>> asked = asking(page(List.of("a", "b", "c", "d")));
    begun();
    hands.press(KeyEvent.VK_3);
    assertThat(WindowFinder.answer(asked).orElseThrow().choice()).isEqualTo(2);
    WindowFinder.closeAll();

    FutureTask<Optional<TrialWindow.Reply>> again = asking(page(List.of("a", "b", "c", "d")));
    begun();
    hands.press(KeyEvent.VK_0);
    assertThat(WindowFinder.answer(again).orElseThrow().choice()).isEqualTo(TrialPage.NONE);
  }

  @Test
  void closingAsksWhetherThePilotIsToEnd() throws IOException {
    FutureTask<Optional<TrialWindow.Reply>> asked = asking(page(List.of()));
    JFrame frame = begun();
    WindowFinder.close(frame);
    WindowFinder.answerDialog(hands, "Yes");
    assertThat(WindowFinder.answer(asked)).isEmpty();
  }
}
