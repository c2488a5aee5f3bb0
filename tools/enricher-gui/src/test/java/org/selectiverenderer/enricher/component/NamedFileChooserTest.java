package org.selectiverenderer.enricher.component;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.testing.RequiresDisplay;
import org.selectiverenderer.testing.robot.GuiRobot;

@RequiresDisplay
class NamedFileChooserTest {
  private final List<String> told = new ArrayList<>();
  private int approved;

  /** A bar is refused by Windows only, the character 0 by every system. */
  @Test
  void aNameThatTheSystemDoesNotAcceptIsToldAndTheChooserStays() {
    GuiRobot.onEdt(
        () -> {
          NamedFileChooser chooser = chooser();
          chooser.setSelectedFile(new File("room\0.x3d"));
          chooser.approveSelection();
          assertThat(told).hasSize(1);
          assertThat(approved).isZero();
          chooser.setSelectedFile(new File("room.x3d"));
          chooser.approveSelection();
          assertThat(told).hasSize(1);
          assertThat(approved).isEqualTo(1);
          return assertThat(chooser.chosen()).hasFileName("room.x3d");
        });
  }

  private NamedFileChooser chooser() {
    NamedFileChooser chooser =
        new NamedFileChooser() {
          private static final long serialVersionUID = 1L;

          @Override
          protected void tell(String sentence) {
            told.add(sentence);
          }
        };
    chooser.addActionListener(event -> approved++);
    return chooser;
  }
}
