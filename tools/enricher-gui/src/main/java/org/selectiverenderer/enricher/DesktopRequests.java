package org.selectiverenderer.enricher;

import java.awt.Desktop;
import java.awt.desktop.QuitStrategy;
import java.io.File;
import java.nio.file.Path;
import java.util.function.Consumer;

/**
 * What macOS asks of a program that runs: to open a file, which it does not name on the command
 * line, and to quit, which closes the window as the author does. Other systems ask nothing.
 */
final class DesktopRequests {
  private DesktopRequests() {}

  /** For the event dispatch thread, on which files come too. */
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
