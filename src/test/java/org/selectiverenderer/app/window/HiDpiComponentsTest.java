package org.selectiverenderer.app.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import javax.swing.JFrame;
import javax.swing.JTextArea;
import javax.swing.JToggleButton;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.testing.RequiresDisplay;

/**
 * Java reads the density of the display once, so a process looks at a display of double density.
 */
@RequiresDisplay
class HiDpiComponentsTest {
  private static final String WORDS = "I can stop at any time without giving a reason, 18-22";

  /** Prints how wide words are before and after they are put into a window. */
  public static final class Measuring {
    private Measuring() {}

    public static void main(String[] arguments) {
      JToggleButton button = new HiDpiComponents.Button(WORDS);
      JTextArea area = new HiDpiComponents.Area(WORDS);
      int outside = button.getPreferredSize().width;
      int around = area.getFontMetrics(area.getFont()).stringWidth(WORDS);
      JFrame frame = new JFrame();
      frame.add(button, "North");
      frame.add(area, "Center");
      frame.pack();
      button.updateUI();
      System.out.printf(
          "scale %s %s %s%n",
          frame.getGraphicsConfiguration().getDefaultTransform().getScaleX(),
          button.getPreferredSize().width == outside,
          area.getFontMetrics(area.getFont()).stringWidth(WORDS) == around);
      frame.dispose();
    }
  }

  @Test
  void wordsAreAsWideBeforeTheyAreInAWindow() throws Exception {
    Process process =
        new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-Dsun.java2d.uiScale=2",
                "-cp",
                System.getProperty("java.class.path"),
                Measuring.class.getName())
            .redirectErrorStream(true)
            .start();
    process.getOutputStream().close();
    String told = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);

    assertThat(process.waitFor()).as(told).isZero();
    assertThat(told.strip()).isEqualTo("scale 2.0 true true");
  }
}
