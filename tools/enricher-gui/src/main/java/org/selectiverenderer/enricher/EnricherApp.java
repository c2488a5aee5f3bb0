package org.selectiverenderer.enricher;

import java.awt.AWTError;
import java.awt.Desktop;
import java.awt.EventQueue;
import java.awt.GraphicsEnvironment;
import java.awt.desktop.QuitStrategy;
import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.function.Consumer;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;

/** Runs the enricher: opens its first window and waits until the author has closed all. */
public final class EnricherApp {
  private EnricherApp() {}

  /**
   * Opens a window and waits until it and those that it has opened are closed.
   *
   * @param scene to open; empty for none
   * @param access folders and hosts that scenes may read from, in addition to those of the settings
   * @param settings folder of the user's settings
   * @throws IOException with one line if there is no display
   * @throws InterruptedException if the waiting thread is interrupted
   */
  public static void run(Optional<Path> scene, ContentAccessPolicy access, Path settings)
      throws IOException, InterruptedException {
    if (!display()) {
      throw new IOException(
          "the enricher's window needs a display; without a display use enrich with "
              + "--apply or --ratings");
    }
    CountDownLatch closed = new CountDownLatch(1);
    EventQueue.invokeLater(
        () -> {
          EnricherWindows windows = new EnricherWindows(settings, access, closed::countDown);
          EnricherWindow window = new EnricherWindow(windows);
          DesktopHandlers.hear(windows::receive);
          window.show();
          window.begin(scene);
        });
    closed.await();
  }

  private static boolean display() {
    try {
      return !GraphicsEnvironment.isHeadless()
          && GraphicsEnvironment.getLocalGraphicsEnvironment().getScreenDevices().length > 0;
    } catch (AWTError e) {
      return false; // DISPLAY names an X server that does not answer
    }
  }

  /**
   * Handles the requests of macOS to a running program: to open a file, which is not named on the
   * command line there, and to quit, which closes the window as the author does. Other systems send
   * no such requests.
   */
  private static final class DesktopHandlers {
    private DesktopHandlers() {}

    /** Installs the handlers; files arrive on the event dispatch thread. */
    static void hear(Consumer<Path> open) {
      if (!Desktop.isDesktopSupported()) {
        return;
      }
      Desktop desktop = Desktop.getDesktop();
      if (desktop.isSupported(Desktop.Action.APP_OPEN_FILE)) {
        desktop.setOpenFileHandler(
            event -> event.getFiles().stream().findFirst().map(File::toPath).ifPresent(open));
      }
      if (desktop.isSupported(Desktop.Action.APP_QUIT_STRATEGY)) {
        desktop.setQuitStrategy(QuitStrategy.CLOSE_ALL_WINDOWS);
      }
    }
  }
}
