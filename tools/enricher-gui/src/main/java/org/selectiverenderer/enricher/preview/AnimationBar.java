package org.selectiverenderer.enricher.preview;

import java.util.Locale;
import java.util.Optional;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSlider;
import javax.swing.JToggleButton;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.enricher.text.Texts;

/**
 * The time slider below the picture of a scene with TimeSensors: plays the animation, lets it
 * stand, and shows any moment of its cycle. It drives the preview's clock, not the document. For
 * the event dispatch thread.
 */
final class AnimationBar extends JPanel {
  private static final long serialVersionUID = 1L;
  private static final int STEPS = 1000;

  private final transient PreviewThread thread;
  private final JToggleButton play = new JToggleButton("\u25b6");
  private final JSlider slider = new JSlider(0, STEPS, 0);
  private final JLabel seconds = new JLabel();
  private double period = 1;
  private boolean showing;

  AnimationBar(PreviewThread thread) {
    super(new MigLayout("insets 0 6 0 6, fillx", "[][grow,fill][]"));
    this.thread = thread;
    play.setName("play");
    play.addActionListener(event -> play(play.isSelected()));
    slider.setName("animation time");
    slider.getAccessibleContext().setAccessibleName(Texts.of("preview.time"));
    slider.setToolTipText(Texts.of("preview.time.tip"));
    slider.addChangeListener(event -> moved());
    seconds.getAccessibleContext().setAccessibleName(Texts.of("preview.seconds"));
    add(play);
    add(slider, "wmin 0");
    add(seconds);
    name();
    setVisible(false);
  }

  private void name() {
    String what = Texts.of(play.isSelected() ? "preview.pause" : "preview.play");
    play.setText(play.isSelected() ? "\u23f8" : "\u25b6");
    play.setToolTipText(what);
    play.getAccessibleContext().setAccessibleName(what);
  }

  private void play(boolean begin) {
    name();
    thread.tell(stage -> stage.play(begin));
  }

  private void moved() {
    if (!showing) {
      double phase = period * slider.getValue() / STEPS;
      show(phase);
      thread.tell(stage -> stage.seek(phase));
    }
  }

  private void show(double phase) {
    Locale locale = Locale.getDefault(Locale.Category.DISPLAY);
    seconds.setText(String.format(locale, "%.1f / %.1f s", phase, period));
  }

  /**
   * Follows the picture; the slider stays where the author drags it.
   *
   * @param phase of the animation; empty for a scene without one
   * @param walking whether the author walks, when time passes in any case
   */
  void follow(Optional<AnimationPhase> phase, boolean walking) {
    if (isVisible() != phase.isPresent()) {
      setVisible(phase.isPresent());
    }
    slider.setEnabled(!walking);
    play.setEnabled(!walking);
    if (phase.isEmpty() || slider.getValueIsAdjusting()) {
      return;
    }
    period = phase.get().period();
    showing = true;
    try {
      slider.setValue((int) Math.round(STEPS * phase.get().seconds() / period));
    } finally {
      showing = false;
    }
    show(phase.get().seconds());
  }
}
