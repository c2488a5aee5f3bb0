package org.selectiverenderer.enricher.preview;

import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JProgressBar;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.base.decimal.DecimalText;
import org.selectiverenderer.enricher.text.Texts;

/** What is said under the picture: that the scene is loaded, why it is not, what is left out. */
final class PreviewFoot extends JPanel {
  private static final long serialVersionUID = 1L;

  /** Keeps the line's height. */
  private static final String NOTHING = " ";

  private final JLabel message = new JLabel(NOTHING);
  private final JProgressBar progress = new JProgressBar();

  /** What is said where the scene has layers that are not shown. */
  private String layersLeftOut = NOTHING;

  PreviewFoot() {
    super(new MigLayout("insets 2 6 2 6, hidemode 3", "[grow,fill][]"));
    progress.setIndeterminate(true);
    progress.setVisible(false);
    progress.getAccessibleContext().setAccessibleName(Texts.of("preview.loading"));
    message.getAccessibleContext().setAccessibleName(Texts.of("preview.state"));
    add(message, "wmin 0");
    add(progress, "wmax 20%");
  }

  void loading() {
    progress.setVisible(true);
    message.setText(Texts.of("preview.loading.now"));
  }

  void loaded() {
    progress.setVisible(false);
    message.setText(NOTHING);
  }

  /** The picture is not of the newest state; a sentence says why. */
  void stale(String sentence) {
    progress.setVisible(false);
    message.setText(sentence);
    message.setToolTipText(sentence);
  }

  /** Says that the picture is not all of the scene, unless something else is said. */
  void layersLeftOut(int others) {
    String before = layersLeftOut;
    layersLeftOut =
        others == 0 ? NOTHING : Texts.of("preview.layers", others, DecimalText.grouped(others));
    if (message.getText().equals(before) || message.getText().isBlank()) {
      message.setText(layersLeftOut);
    }
  }

  String message() {
    return message.getText();
  }
}
