package org.selectiverenderer.enricher;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.EventQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import javax.swing.JProgressBar;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.selectiverenderer.enricher.task.TaskExecutor;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.testing.robot.GuiRobot;

/** What the status bar shows of tasks in the background. */
@ShowsWindows
@Timeout(value = 60, unit = TimeUnit.SECONDS)
class StatusBarTest {
  @Test
  void aTaskIsNamedByItsProgressUnlessItIsAnnounced() {
    GuiRobot hands = new GuiRobot();
    CountDownLatch end = new CountDownLatch(1);
    try (TaskExecutor tasks = new TaskExecutor(EventQueue::invokeLater)) {
      StatusBar status = GuiRobot.onEdt(() -> new StatusBar(tasks));
      JProgressBar bar = GuiRobot.named(status.component(), "Progress", JProgressBar.class);
      GuiRobot.onEdt(
          () -> {
            status.announced("Opening a.x3d");
            return tasks.run(
                "Opening a.x3d", () -> end.await(1, TimeUnit.MINUTES), done -> {}, failed -> {});
          });
      hands.await("the progress", bar::isVisible);
      assertThat(GuiRobot.onEdt(bar::isStringPainted)).isFalse();
      GuiRobot.onEdt(
          () -> {
            status.announced("");
            return true;
          });
      hands.await(
          "the name", () -> bar.isStringPainted() && bar.getString().equals("Opening a.x3d"));
      end.countDown();
      hands.await("the end", () -> !bar.isVisible());
      GuiRobot.onEdt(
          () -> {
            status.dispose();
            return true;
          });
    }
  }
}
