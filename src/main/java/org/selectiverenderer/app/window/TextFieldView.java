package org.selectiverenderer.app.window;

import com.formdev.flatlaf.FlatClientProperties;
import java.awt.FlowLayout;
import java.awt.KeyboardFocusManager;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import javax.swing.Timer;
import javax.swing.event.DocumentEvent;
import javax.swing.event.DocumentListener;
import javax.swing.text.JTextComponent;
import org.selectiverenderer.study.questionnaire.AnswerField;
import org.selectiverenderer.swing.PlainText;

/**
 * Shows a field for a text or a number. A value is reported as final when the participant stops
 * typing.
 */
final class TextFieldView implements FieldView {
  /** Milliseconds without a key after which the typed text is final. */
  private static final int REST = 800;

  private static final int COLUMNS = 48;
  private static final int NUMBER_COLUMNS = 8;

  private final AnswerField.Line field;
  private final Listener listener;
  private final Runnable touched;
  private final JPanel panel =
      new JPanel(new FlowLayout(FlowLayout.LEFT, QuestionRowLayout.GAP, 0));
  private final JTextComponent text;
  private final JLabel unit = PlainText.only(new JLabel());
  private final Timer rest = new Timer(REST, event -> settle());
  private String told = "";
  private boolean showing;

  /**
   * @param touched runs when the participant clicks into the field
   */
  TextFieldView(
      AnswerField.Line field, String id, String asked, Listener listener, Runnable touched) {
    this.field = field;
    this.listener = listener;
    this.touched = touched;
    rest.setRepeats(false);
    panel.setOpaque(false);
    panel.setAlignmentX(0);
    if (field.lines() > 1) {
      JTextArea area = new JTextArea(field.lines(), COLUMNS);
      area.setLineWrap(true);
      area.setWrapStyleWord(true);
      area.setFocusTraversalKeys(KeyboardFocusManager.FORWARD_TRAVERSAL_KEYS, null);
      area.setFocusTraversalKeys(KeyboardFocusManager.BACKWARD_TRAVERSAL_KEYS, null);
      text = area;
      panel.add(new JScrollPane(area));
    } else {
      text = new JTextField(field.range().isPresent() ? NUMBER_COLUMNS : COLUMNS);
      panel.add(text);
    }
    text.setFont(text.getFont().deriveFont(15f));
    text.setName(id);
    text.getAccessibleContext().setAccessibleName(asked);
    unit.setText(
        field
            .range()
            .map(range -> field.unit() + "  (" + range.dashed() + ")")
            .orElse(field.unit()));
    panel.add(unit);
    text.addFocusListener(
        new FocusAdapter() {
          @Override
          public void focusGained(FocusEvent event) {
            // A window that opens focuses its first text field; only a click is the participant's.
            if (event.getCause() == FocusEvent.Cause.MOUSE_EVENT) {
              touched.run();
            }
          }

          @Override
          public void focusLost(FocusEvent event) {
            settle();
          }
        });
    text.getDocument()
        .addDocumentListener(
            new DocumentListener() {
              @Override
              public void insertUpdate(DocumentEvent event) {
                typed();
              }

              @Override
              public void removeUpdate(DocumentEvent event) {
                typed();
              }

              @Override
              public void changedUpdate(DocumentEvent event) {
                // Plain text has no styles to change.
              }
            });
  }

  private Optional<String> value() {
    return text.getText().isBlank() ? Optional.of("") : field.typed(text.getText());
  }

  private void typed() {
    if (showing) {
      return;
    }
    Optional<String> value = value();
    text.putClientProperty(
        FlatClientProperties.OUTLINE, value.isEmpty() ? FlatClientProperties.OUTLINE_ERROR : null);
    listener.filled(value.orElse(""), false);
    rest.restart();
  }

  @Override
  public void settle() {
    rest.stop();
    String value = value().orElse("");
    if (!value.equals(told)) {
      told = value;
      listener.filled(value, true);
    }
  }

  @Override
  public JComponent component() {
    return panel;
  }

  @Override
  public void show(String value) {
    if (value().equals(Optional.of(value))) {
      told = value;
      return; // The value is what was typed: the caret stays.
    }
    showing = true;
    told = value;
    text.setText(value);
    showing = false;
  }

  @Override
  public boolean key(char typed) {
    return false; // The text field handles keys itself.
  }

  @Override
  public void focus() {
    text.requestFocusInWindow();
  }

  @Override
  public boolean takesText() {
    return true;
  }
}
