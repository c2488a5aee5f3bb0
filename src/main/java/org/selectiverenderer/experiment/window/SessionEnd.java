package org.selectiverenderer.experiment.window;

import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.util.function.BooleanSupplier;
import javax.swing.JFrame;
import javax.swing.Timer;

/**
 * How a participant's window ends before it is answered: whoever closes it has the experimenter
 * asked, and when the session has ended the window goes.
 *
 * @param over whether the session has ended
 * @param closing somebody closes the window
 */
public record SessionEnd(BooleanSupplier over, Runnable closing) {
  /** Milliseconds between looks whether the session has ended. */
  private static final int LOOK = 200;

  /** Minds a window until it is disposed of. */
  void watch(JFrame frame, Runnable ended) {
    Timer watch =
        new Timer(
            LOOK,
            event -> {
              if (over.getAsBoolean()) {
                ended.run();
              }
            });
    frame.addWindowListener(new ClosingAsks(closing));
    frame.addWindowListener(
        new WindowAdapter() {
          @Override
          public void windowClosed(WindowEvent event) {
            watch.stop();
          }
        });
    watch.start();
  }
}
