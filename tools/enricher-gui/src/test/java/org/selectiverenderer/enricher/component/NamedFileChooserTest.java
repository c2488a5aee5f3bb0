package org.selectiverenderer.enricher.component;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.Container;
import java.io.File;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import javax.swing.AbstractButton;
import javax.swing.JLabel;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.ResourceLock;
import org.junit.jupiter.api.parallel.Resources;
import org.selectiverenderer.enricher.text.ToolkitTexts;
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

  @Test
  @ResourceLock(Resources.LOCALE)
  void inGreekTheChooserIsGreek() {
    Locale before = Locale.getDefault(Locale.Category.DISPLAY);
    try {
      ToolkitTexts.install();
      Locale.setDefault(Locale.Category.DISPLAY, Locale.forLanguageTag("el"));
      List<String> texts =
          GuiRobot.onEdt(
              () -> {
                List<String> shown = new ArrayList<>();
                collect(chooser(), shown);
                return shown;
              });
      assertThat(texts)
          .contains("\u0386\u03bd\u03bf\u03b9\u03b3\u03bc\u03b1")
          .noneMatch(text -> text.matches("(?s).*\\b(Open|Cancel|Files?|Folder|Look|List).*"));
    } finally {
      Locale.setDefault(Locale.Category.DISPLAY, before);
    }
  }

  private static void collect(Container in, List<String> texts) {
    for (Component each : in.getComponents()) {
      if (each instanceof JLabel label) {
        texts.add(String.valueOf(label.getText()));
      } else if (each instanceof AbstractButton button) {
        texts.add(button.getText() + " " + button.getToolTipText());
        texts.add(String.valueOf(button.getText()));
      }
      if (each instanceof Container more) {
        collect(more, texts);
      }
    }
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
