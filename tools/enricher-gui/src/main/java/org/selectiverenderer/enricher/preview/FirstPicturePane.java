package org.selectiverenderer.enricher.preview;

import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JProgressBar;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.swing.PlainText;

/** Says in place of the picture what is waited for, or why there is none. */
final class FirstPicturePane extends JPanel {
  private static final long serialVersionUID = 1L;

  private final JLabel word = PlainText.only(new JLabel());
  private final JProgressBar progress = new JProgressBar();

  FirstPicturePane() {
    super(new MigLayout("insets 12, wrap 1, hidemode 3", "[center]"));
    setOpaque(false);
    progress.setIndeterminate(true);
    progress.getAccessibleContext().setAccessibleName(Texts.of("preview.loading"));
    add(word, "wmin 0");
    add(progress, "w 200!");
    loading();
  }

  void loading() {
    say(Texts.of("preview.loading.now"), true);
  }

  /** The scene is read; its picture is being drawn. */
  void drawing() {
    say(Texts.of("preview.drawing"), true);
  }

  /** There is no picture for a reason. */
  void none(String why) {
    say(why, false);
  }

  private void say(String sentence, boolean busy) {
    word.setText(sentence);
    word.setToolTipText(PlainText.of(sentence));
    word.getAccessibleContext().setAccessibleName(sentence);
    progress.setVisible(busy);
  }

  /** Returns the sentence that is shown. */
  String said() {
    return word.getText();
  }
}
