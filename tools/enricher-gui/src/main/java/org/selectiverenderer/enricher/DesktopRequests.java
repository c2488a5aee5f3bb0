package org.selectiverenderer.enricher;

import java.awt.Desktop;
import java.awt.desktop.QuitStrategy;
import java.io.File;
import java.nio.file.Path;
import java.util.function.Consumer;

/**
 * Handles the requests of macOS to a running program: to open a file, which is not named on the
 * command line there, and to quit, which closes the window as the author does. Other systems send
 * no such requests.
 */
final class DesktopRequests {
  private DesktopRequests() {}

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
