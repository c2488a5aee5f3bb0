package org.selectiverenderer.app.window;

import java.awt.BorderLayout;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.WindowConstants;
import org.selectiverenderer.study.questionnaire.ParticipantMessages;
import org.selectiverenderer.swing.PlainText;
import org.selectiverenderer.swing.WindowPacker;

/** The window that tells the participant that the session is over. */
public final class ThanksWindow {
  private ThanksWindow() {}

  /**
   * Shows the window until it is closed.
   *
   * @param desk the participant's monitor
   */
  public static void show(ParticipantMessages wording, MonitorBounds desk) {
    ModalWindowRunner.on(done -> frame(wording, desk, done));
  }

  private static JFrame frame(ParticipantMessages wording, MonitorBounds desk, Runnable done) {
    JFrame frame = new JFrame(wording.of("thanks.title"), desk.configuration());
    frame.setName("thanks");
    frame.setDefaultCloseOperation(WindowConstants.DO_NOTHING_ON_CLOSE);
    frame.addWindowListener(new CloseInterceptor(done));
    JLabel text = new JLabel(PlainText.of(wording.of("thanks.text")));
    text.setFont(text.getFont().deriveFont(18f));
    text.setBorder(BorderFactory.createEmptyBorder(32, 32, 32, 32));
    JButton close = new JButton(PlainText.of(wording.of("close")));
    close.setName("close");
    close.addActionListener(event -> done.run());
    frame.add(text, BorderLayout.CENTER);
    frame.add(close, BorderLayout.SOUTH);
    frame.getRootPane().setDefaultButton(close);
    WindowPacker.pack(frame);
    desk.center(frame);
    return frame;
  }
}
