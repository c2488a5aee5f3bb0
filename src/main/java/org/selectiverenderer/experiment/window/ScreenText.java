package org.selectiverenderer.experiment.window;

import java.awt.GraphicsConfiguration;
import java.awt.GraphicsEnvironment;
import javax.swing.JCheckBox;
import javax.swing.JLabel;
import javax.swing.JRadioButton;
import javax.swing.JTextArea;
import javax.swing.JToggleButton;
import org.jspecify.annotations.Nullable;

/**
 * Parts of a page that are as wide before they are in a window as they will be there. On a display
 * of double density letters are a little wider, so that words measured for a single one would be
 * cut off; Swing asks the window for the density, and without a window takes it for single.
 */
final class ScreenText {
  private ScreenText() {}

  /** A part's own display, or where it has none yet the usual one. */
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
      super(text);
    }

    @Override
    public GraphicsConfiguration getGraphicsConfiguration() {
      return display(super.getGraphicsConfiguration());
    }
  }

  static final class CheckBox extends JCheckBox {
    private static final long serialVersionUID = 1;

    CheckBox(String text) {
      super(text);
    }

    @Override
    public GraphicsConfiguration getGraphicsConfiguration() {
      return display(super.getGraphicsConfiguration());
    }
  }

  static final class RadioButton extends JRadioButton {
    private static final long serialVersionUID = 1;

    RadioButton(String text) {
      super(text);
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
