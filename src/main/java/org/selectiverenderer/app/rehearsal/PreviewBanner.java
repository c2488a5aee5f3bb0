package org.selectiverenderer.app.rehearsal;

import java.awt.Color;
import java.awt.Font;
import java.io.IOException;
import java.util.Optional;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JWindow;
import javax.swing.SwingUtilities;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.app.narration.Narration;
import org.selectiverenderer.app.session.SessionUi;
import org.selectiverenderer.study.session.ExperimenterControls;
import org.selectiverenderer.study.session.Session;
import org.selectiverenderer.study.session.SessionStep;

/** Shows a banner above all windows of a session that is a preview. */
public final class PreviewBanner implements SessionUi {
  private final SessionUi dialogue;
  private volatile @Nullable JWindow banner;

  /**
   * @param dialogue the user interface of the session; is closed with the banner
   */
  public PreviewBanner(SessionUi dialogue) {
    this.dialogue = dialogue;
  }

  @Override
  public void open(ExperimenterControls controls) {
    SwingUtilities.invokeLater(
        () -> {
          JWindow window = new JWindow();
          JLabel label = new JLabel("PREVIEW");
          label.setOpaque(true);
          label.setBackground(new Color(0xa00000));
          label.setForeground(Color.WHITE);
          label.setFont(label.getFont().deriveFont(Font.BOLD, 20f));
          label.setBorder(BorderFactory.createEmptyBorder(4, 24, 4, 24));
          window.add(label);
          window.setAlwaysOnTop(true);
          window.setFocusableWindowState(false);
          window.pack();
          window.setLocationRelativeTo(null);
          window.setLocation(window.getX(), 0);
          window.setVisible(true);
          banner = window;
        });
    dialogue.open(controls);
  }

  @Override
  public void narrate(Narration narration) {
    dialogue.narrate(narration);
  }

  @Override
  public Optional<String> form(Session session, ExperimenterControls controls) throws IOException {
    return dialogue.form(session, controls);
  }

  @Override
  public boolean questions(
      Session session, SessionStep.Questions step, ExperimenterControls controls)
      throws IOException {
    return dialogue.questions(session, step, controls);
  }

  @Override
  public void thanks(Session session) {
    dialogue.thanks(session);
  }

  @Override
  public void close() {
    SwingUtilities.invokeLater(
        () -> {
          JWindow window = banner;
          if (window != null) {
            window.dispose();
          }
        });
    dialogue.close();
  }
}
