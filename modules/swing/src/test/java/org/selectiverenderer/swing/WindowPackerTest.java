package org.selectiverenderer.swing;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Dimension;
import java.awt.Point;
import javax.swing.JButton;
import javax.swing.JFrame;
import javax.swing.JPanel;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.testing.WindowFinder;
import org.selectiverenderer.testing.robot.GuiRobot;

@ShowsWindows
class WindowPackerTest {
  @AfterEach
  void leave() {
    WindowFinder.closeAll();
  }

  @Test
  void hasItsSizeBeforeThereIsANativeWindowThatCouldStandElsewhere() {
    JFrame frame =
        GuiRobot.onEdt(
            () -> {
              JFrame made = new JFrame();
              JPanel content = new JPanel();
              content.setPreferredSize(new Dimension(300, 200));
              made.setContentPane(content);
              WindowPacker.pack(made);
              assertThat(made.isDisplayable()).isFalse();
              made.setLocation(70, 80);
              made.setVisible(true);
              return made;
            });

    GuiRobot.onEdt(
        () -> {
          assertThat(frame.getContentPane().getSize()).isEqualTo(new Dimension(300, 200));
          assertThat(frame.getLocation()).isEqualTo(new Point(70, 80));
          return true;
        });
  }

  @Test
  void aPackedWindowKeepsTheButtonThatEnterPresses() {
    JFrame made = GuiRobot.onEdt(() -> new JFrame());
    JButton button = GuiRobot.onEdt(() -> new JButton("Save"));
    GuiRobot.onEdt(
        () -> {
          made.getContentPane().add(button);
          made.getRootPane().setDefaultButton(button);
          WindowPacker.pack(made);
          return true;
        });
    assertThat(GuiRobot.onEdt(made.getRootPane()::getDefaultButton)).isSameAs(button);
    GuiRobot.onEdt(
        () -> {
          made.setVisible(true);
          return true;
        });
    assertThat(GuiRobot.onEdt(made.getRootPane()::getDefaultButton)).isSameAs(button);
  }
}
