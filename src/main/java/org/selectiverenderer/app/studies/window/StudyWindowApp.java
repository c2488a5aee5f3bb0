package org.selectiverenderer.app.studies.window;

import java.awt.AWTError;
import java.awt.EventQueue;
import java.awt.GraphicsEnvironment;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import org.selectiverenderer.enricher.settings.EnricherSettings;
import org.selectiverenderer.enricher.settings.FontZoom;
import org.selectiverenderer.enricher.settings.Language;
import org.selectiverenderer.enricher.settings.Theme;

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
    if (!display()) {
      throw new IOException(
          "the study window needs a display; without a display use the commands that experiment"
              + " --help lists");
    }
    CountDownLatch closed = new CountDownLatch(1);
    EventQueue.invokeLater(
        () -> {
          look(settings);
          new StudyWindow(settings, closed::countDown).begin(study);
        });
    closed.await();
  }

  /** Applies theme, text size and language of the enricher's settings. */
  static void look(Path folder) {
    EnricherSettings settings = new EnricherSettings(folder);
    try {
      settings.load();
    } catch (IOException e) {
      // The defaults apply; the enricher's window tells of settings that cannot be read.
    }
    Language.of(settings).apply();
    Theme.of(settings.word("theme", "")).apply();
    new FontZoom(settings).apply();
  }

  private static boolean display() {
    try {
      return !GraphicsEnvironment.isHeadless()
          && GraphicsEnvironment.getLocalGraphicsEnvironment().getScreenDevices().length > 0;
    } catch (AWTError e) {
      return false; // DISPLAY names an X server that does not answer
    }
  }
}
