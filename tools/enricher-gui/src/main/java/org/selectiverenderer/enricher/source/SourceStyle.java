package org.selectiverenderer.enricher.source;

import com.formdev.flatlaf.FlatLaf;
import java.awt.Color;
import java.io.IOException;
import java.io.InputStream;
import javax.swing.UIManager;
import org.fife.ui.rsyntaxtextarea.RSyntaxTextArea;
import org.fife.ui.rsyntaxtextarea.Theme;
import org.fife.ui.rtextarea.RTextScrollPane;

/** The colours and the font of the source view, following the theme of the window. */
final class SourceStyle {
  private static final int CURRENT_LINE = 16;

  private SourceStyle() {}

  static void apply(RSyntaxTextArea area, RTextScrollPane scroll) {
    String name = FlatLaf.isLafDark() ? "dark.xml" : "idea.xml";
    try (InputStream in =
        RSyntaxTextArea.class.getResourceAsStream("/org/fife/ui/rsyntaxtextarea/themes/" + name)) {
      if (in != null) {
        Theme.load(in).apply(area);
      }
    } catch (IOException e) {
      throw new IllegalStateException("a theme of the text area is damaged", e);
    }
    area.setFont(UIManager.getFont("monospaced.font"));
    area.setBackground(UIManager.getColor("TextArea.background"));
    Color text = UIManager.getColor("TextArea.foreground");
    // Translucent, or it would hide the highlight of a fault in the caret's line.
    area.setCurrentLineHighlightColor(
        new Color(text.getRed(), text.getGreen(), text.getBlue(), CURRENT_LINE));
    scroll.getGutter().setBackground(UIManager.getColor("Panel.background"));
    scroll.getGutter().setLineNumberFont(area.getFont());
    scroll.getGutter().setLineNumberColor(UIManager.getColor("Label.disabledForeground"));
    scroll.getGutter().setFoldBackground(UIManager.getColor("TextArea.background"));
    scroll.getGutter().setFoldIndicatorForeground(UIManager.getColor("Label.disabledForeground"));
    scroll.getGutter().setBorderColor(UIManager.getColor("Component.borderColor"));
  }

  static Color errorLine() {
    return mixed("TextArea.background", "Actions.Red", 0.25);
  }

  static Color elementTag() {
    return mixed("TextArea.background", "Component.accentColor", 0.22);
  }

  static Color hit() {
    return mixed("TextArea.background", "Actions.Yellow", 0.5);
  }

  private static Color mixed(String one, String other, double part) {
    Color a = UIManager.getColor(one);
    Color b = UIManager.getColor(other);
    return new Color(
        mixed(a.getRed(), b.getRed(), part),
        mixed(a.getGreen(), b.getGreen(), part),
        mixed(a.getBlue(), b.getBlue(), part));
  }

  private static int mixed(int a, int b, double part) {
    return (int) Math.round(a + (b - a) * part);
  }
}
