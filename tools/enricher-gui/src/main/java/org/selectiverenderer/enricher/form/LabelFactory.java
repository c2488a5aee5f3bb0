package org.selectiverenderer.enricher.form;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Rectangle;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextArea;
import javax.swing.UIManager;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.swing.PlainText;

/** Creates the labels and read-only texts of forms. */
final class LabelFactory {
  private LabelFactory() {}

  /** Creates the label of a control. */
  static JLabel of(String text, JComponent control) {
    JLabel label = new JLabel(PlainText.of(text));
    label.setLabelFor(control);
    return label;
  }

  /**
   * Creates the label of a control, with the name of its metadata (thesis 4.2.2) as tooltip.
   *
   * @param name of the metadata
   */
  static JLabel of(String text, JComponent control, String name) {
    JLabel label = of(text, control);
    label.setToolTipText(Texts.of("terms.inthesis", name));
    label.getAccessibleContext().setAccessibleDescription(label.getToolTipText());
    return label;
  }

  /** Creates a small header with the metadata names of the thesis. */
  static JTextArea names(String... names) {
    JTextArea area = sentences(Texts.of("terms.names", String.join(", ", names)));
    area.setFont(UIManager.getFont("small.font"));
    area.setEnabled(false);
    return area;
  }

  /** Creates a red label for what is wrong with a control's text. */
  static JLabel complaint() {
    JLabel label =
        new JLabel() {
          private static final long serialVersionUID = 1L;

          @Override
          public Color getForeground() {
            Color red = UIManager.getColor("Actions.Red");
            return red == null ? super.getForeground() : red;
          }
        };
    PlainText.only(label);
    label.getAccessibleContext().setAccessibleName(Texts.of("form.wrong"));
    return label;
  }

  /**
   * Creates a line of constant height for error messages, so that nothing moves under the mouse
   * when one appears.
   */
  static JPanel room(JLabel... complaints) {
    JPanel line =
        new JPanel(new MigLayout("insets 0, hidemode 3", "", "[]")) {
          private static final long serialVersionUID = 1L;

          @Override
          public Dimension getPreferredSize() {
            int height = complaints[0].getFontMetrics(complaints[0].getFont()).getHeight();
            return new Dimension(super.getPreferredSize().width, height);
          }
        };
    line.setOpaque(false);
    for (JLabel complaint : complaints) {
      complaint.putClientProperty("FlatLaf.styleClass", "small");
      line.add(complaint, "wmin 0, h 100%!");
    }
    return line;
  }

  /** Creates a read-only text that wraps at the available width. */
  static JTextArea sentences(String text) {
    JTextArea area =
        new JTextArea(text) {
          private static final long serialVersionUID = 1L;

          @Override
          public void scrollRectToVisible(Rectangle rectangle) {
            // Its caret, which nobody sees, would scroll the form to a text that is set.
          }
        };
    area.setEditable(false);
    area.setFocusable(false);
    area.setOpaque(false);
    area.setLineWrap(true);
    area.setWrapStyleWord(true);
    area.setBorder(null);
    area.setFont(UIManager.getFont("Label.font"));
    area.getAccessibleContext().setAccessibleName(text);
    return area;
  }
}
