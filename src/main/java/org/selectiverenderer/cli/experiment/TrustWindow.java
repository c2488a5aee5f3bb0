package org.selectiverenderer.cli.experiment;

import java.util.List;
import java.util.Optional;
import org.selectiverenderer.command.LibraryProperties;
import org.selectiverenderer.render.window.Monitors;
import org.selectiverenderer.swing.TrustDialog;

/**
 * Asks by a window what a study may have beyond its own folder, before its session opens others.
 */
final class TrustWindow {
  private TrustWindow() {}

  static Optional<Boolean> ask(String sentence, List<String> lines) {
    Monitors.all(); // This starts JOGL; Swing may start only afterwards.
    LibraryProperties.allowSwing();
    return TrustDialog.ask(
        Optional.empty(),
        new TrustDialog.Words(
            "Selective Renderer",
            sentence + ":",
            "Agree only if you expect this of whoever sent it. It is remembered until this list"
                + " changes.",
            "Agree",
            "Cancel"),
        lines);
  }
}
