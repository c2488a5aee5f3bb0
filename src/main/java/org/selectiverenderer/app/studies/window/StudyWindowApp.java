package org.selectiverenderer.app.studies.window;

import java.awt.EventQueue;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import org.selectiverenderer.enricher.settings.WindowLook;
import org.selectiverenderer.swing.Screen;

/** Runs the study window: opens it and waits until the experimenter closes it. */
public final class StudyWindowApp {
  private StudyWindowApp() {}

  /**
   * Opens the window and waits until it is closed.
   *
   * @param study to open; empty for none
   * @param settings folder of the user's settings
   * @throws IOException with one line if there is no display
   * @throws InterruptedException if the waiting thread is interrupted
   */
  public static void run(Optional<Path> study, Path settings)
      throws IOException, InterruptedException {
    if (!Screen.exists()) {
      throw new IOException(
          "the study window needs a display; without a display use the commands that experiment"
              + " --help lists");
    }
    CountDownLatch closed = new CountDownLatch(1);
    EventQueue.invokeLater(
        () -> {
          WindowLook.apply(settings);
          new StudyWindow(settings, closed::countDown).begin(study);
        });
    closed.await();
  }
}
