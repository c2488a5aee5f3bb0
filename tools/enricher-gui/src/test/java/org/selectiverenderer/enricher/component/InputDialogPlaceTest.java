package org.selectiverenderer.enricher.component;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.Rectangle;
import java.util.Optional;
import javax.swing.JDialog;
import javax.swing.JFrame;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.testing.robot.GuiRobot;

@ShowsWindows
class InputDialogPlaceTest {
  private final GuiRobot hands = new GuiRobot();

  @Test
  void theNameOfWhatAViewShowsIsAskedForBesideTheView() {
    JPanel view = new JPanel();
    JFrame frame =
        GuiRobot.onEdt(
            () -> {
              JFrame made = new JFrame();
              JPanel form = new JPanel();
              form.setPreferredSize(new Dimension(300, 600));
              made.add(view, BorderLayout.CENTER);
              made.add(form, BorderLayout.EAST);
              made.setBounds(0, 0, 900, 600);
              return made;
            });
    hands.show(frame);
    try {
      SwingUtilities.invokeLater(
          () -> InputDialog.askBeside(view, "New Area", "Name", "Area", name -> Optional.empty()));
      JDialog dialog = hands.dialog(JDialog.class);
      Rectangle seen =
          GuiRobot.onEdt(() -> new Rectangle(view.getLocationOnScreen(), view.getSize()));
      assertThat(GuiRobot.onEdt(dialog::getBounds).intersects(seen)).isFalse();
      hands.choose(dialog, "Cancel");
    } finally {
      GuiRobot.onEdt(
          () -> {
            frame.dispose();
            return true;
          });
    }
  }
}
