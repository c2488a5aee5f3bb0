package org.selectiverenderer.enricher.source;

import java.awt.Component;
import java.awt.event.ActionEvent;
import java.util.List;
import javax.swing.AbstractAction;
import javax.swing.KeyStroke;
import org.fife.ui.rsyntaxtextarea.RSyntaxTextArea;
import org.fife.ui.rtextarea.ExpandedFoldRenderStrategy;
import org.fife.ui.rtextarea.FoldIndicator;
import org.fife.ui.rtextarea.RTextScrollPane;
import org.selectiverenderer.enricher.text.Texts;

/** The settings of the text area of the source view, with its names for screen readers. */
final class SourceAreaSetup {
  /**
   * Keys that the window or the panel handles, so that the text area's own bindings are removed.
   */
  private static final List<String> KEYS =
      List.of(
          "ctrl Z",
          "ctrl Y",
          "ctrl shift Z",
          "ctrl shift F",
          "ctrl F",
          "ctrl H",
          "ctrl G",
          "ctrl D",
          "ctrl shift M",
          "ctrl SLASH",
          "F3",
          "shift F3");

  private SourceAreaSetup() {}

  static void apply(RSyntaxTextArea area, RTextScrollPane scroll) {
    area.setName("source");
    area.setAntiAliasingEnabled(true);
    area.setMarkOccurrences(false);
    area.setTabSize(2);
    area.setHighlightCurrentLine(true);
    area.setCloseMarkupTags(true);
    for (String key : KEYS) {
      area.getInputMap().put(KeyStroke.getKeyStroke(key), "none"); // left to the window
    }
    area.getAccessibleContext().setAccessibleName(Texts.of("source.panel"));
    scroll.setFoldIndicatorEnabled(true);
    scroll.getGutter().setExpandedFoldRenderStrategy(ExpandedFoldRenderStrategy.ALWAYS);
    for (Component each : scroll.getGutter().getComponents()) {
      if (each instanceof FoldIndicator) {
        each.getAccessibleContext().setAccessibleName(Texts.of("source.folds"));
      }
    }
    scroll
        .getVerticalScrollBar()
        .getAccessibleContext()
        .setAccessibleName(Texts.of("source.scroll"));
    scroll
        .getHorizontalScrollBar()
        .getAccessibleContext()
        .setAccessibleName(Texts.of("source.scroll"));
  }

  /** Has a key in the area run something. */
  static void key(RSyntaxTextArea area, String key, Runnable run) {
    area.getInputMap().put(KeyStroke.getKeyStroke(key), key);
    area.getActionMap()
        .put(
            key,
            new AbstractAction() {
              private static final long serialVersionUID = 1L;

              @Override
              public void actionPerformed(ActionEvent event) {
                run.run();
              }
            });
  }
}
