package org.selectiverenderer.app.start.window;

import java.awt.Desktop;
import java.awt.EventQueue;
import java.awt.desktop.QuitStrategy;
import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.CountDownLatch;
import org.selectiverenderer.enricher.settings.WindowLook;
import org.selectiverenderer.swing.Screen;

/** Runs the start window: opens it and waits until the user closes it. */
public final class StartWindowApp {
  private StartWindowApp() {}

  /**
   * Opens the window and waits until it is closed.
   *
   * @param settings folder of the user's settings
   * @throws IOException with one line if there is no display
   * @throws InterruptedException if the waiting thread is interrupted
   */
  public static void run(Path settings) throws IOException, InterruptedException {
    if (!Screen.exists()) {
      throw new IOException(
          "the start window needs a display; without a display use the commands that --help lists");
    }
    CountDownLatch closed = new CountDownLatch(1);
    EventQueue.invokeLater(
        () -> {
          WindowLook.apply(settings);
          StartWindow window = new StartWindow(settings, closed::countDown);
          hear(window);
          window.begin();
        });
    closed.await();
  }

  /**
   * Handles the requests of macOS to a running program: to open a file, which is not named on the
   * command line there, and to quit. Other systems send no such requests.
   */
  private static void hear(StartWindow window) {
    if (!Desktop.isDesktopSupported()) {
      return;
    }
    Desktop desktop = Desktop.getDesktop();
    if (desktop.isSupported(Desktop.Action.APP_OPEN_FILE)) {
      desktop.setOpenFileHandler(
          event -> event.getFiles().forEach(file -> window.enrich(file.toPath())));
    }
    if (desktop.isSupported(Desktop.Action.APP_QUIT_STRATEGY)) {
      desktop.setQuitStrategy(QuitStrategy.CLOSE_ALL_WINDOWS);
    }
  }
}
