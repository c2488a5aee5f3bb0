package org.selectiverenderer.app.window;

import java.awt.GraphicsConfiguration;
import java.awt.GraphicsEnvironment;
import javax.swing.JCheckBox;
import javax.swing.JLabel;
import javax.swing.JRadioButton;
import javax.swing.JTextArea;
import javax.swing.JToggleButton;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.swing.PlainText;

/**
 * Swing components that have the same preferred width before they are added to a window as in it.
 * On a HiDPI display (scale 2) letters are a little wider, so that words measured at scale 1 would
 * be cut off; Swing takes the scale from the window, and without a window assumes 1.
 */
final class HiDpiComponents {
  private HiDpiComponents() {}

  /** Returns a component's graphics configuration, or the default one if it has none yet. */
  private static GraphicsConfiguration display(@Nullable GraphicsConfiguration own) {
    return own != null
        ? own
        : GraphicsEnvironment.getLocalGraphicsEnvironment()
            .getDefaultScreenDevice()
            .getDefaultConfiguration();
  }

  static final class Label extends JLabel {
    private static final long serialVersionUID = 1;

    @Override
    public GraphicsConfiguration getGraphicsConfiguration() {
      return display(super.getGraphicsConfiguration());
    }
  }

  static final class Button extends JToggleButton {
    private static final long serialVersionUID = 1;

    Button(String text) {
      super(PlainText.of(text));
    }

    @Override
    public GraphicsConfiguration getGraphicsConfiguration() {
      return display(super.getGraphicsConfiguration());
    }
  }

  static final class CheckBox extends JCheckBox {
    private static final long serialVersionUID = 1;

    CheckBox(String text) {
      super(PlainText.of(text));
    }

    @Override
    public GraphicsConfiguration getGraphicsConfiguration() {
      return display(super.getGraphicsConfiguration());
    }
  }

  static final class RadioButton extends JRadioButton {
    private static final long serialVersionUID = 1;

    RadioButton(String text) {
      super(PlainText.of(text));
    }

    @Override
    public GraphicsConfiguration getGraphicsConfiguration() {
      return display(super.getGraphicsConfiguration());
    }
  }

  static final class Area extends JTextArea {
    private static final long serialVersionUID = 1;

    Area(String text) {
      super(text);
    }

    @Override
    public GraphicsConfiguration getGraphicsConfiguration() {
      return display(super.getGraphicsConfiguration());
    }
  }
}
