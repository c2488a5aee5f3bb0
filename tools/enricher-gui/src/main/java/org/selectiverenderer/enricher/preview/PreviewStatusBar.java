package org.selectiverenderer.enricher.preview;

import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JProgressBar;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.enricher.text.AccessHint;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.swing.PlainText;

/**
 * The status line below the picture: whether the scene is being loaded, why it is not shown, and
 * which layers are left out.
 */
final class PreviewStatusBar extends JPanel {
  private static final long serialVersionUID = 1L;

  /** Keeps the line's height. */
  private static final String NOTHING = " ";

  private final JLabel message = PlainText.only(new JLabel(NOTHING));
  private final JProgressBar progress = new JProgressBar();

  /** The message about layers that are not shown. */
  private String layersLeftOut = NOTHING;

  PreviewStatusBar() {
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

  /** Shows why the picture is not of the newest state of the document. */
  void stale(String sentence) {
    progress.setVisible(false);
    String said = AccessHint.inWindow(sentence);
    message.setText(said);
    message.setToolTipText(PlainText.of(said));
  }

  /** Shows how many layers are left out, unless another message is shown. */
  void layersLeftOut(int others) {
    String before = layersLeftOut;
    layersLeftOut =
        others == 0
            ? NOTHING
            : Texts.of("preview.layers", others, DecimalFormatter.grouped(others));
    if (message.getText().equals(before) || message.getText().isBlank()) {
      message.setText(layersLeftOut);
    }
  }

  String message() {
    return message.getText();
  }
}
