package org.selectiverenderer.app.window;

import com.formdev.flatlaf.FlatClientProperties;
import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.FlowLayout;
import java.awt.Font;
import java.awt.GridLayout;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import javax.swing.BorderFactory;
import javax.swing.Box;
import javax.swing.BoxLayout;
import javax.swing.ButtonGroup;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JToggleButton;
import javax.swing.SwingConstants;
import javax.swing.Timer;
import org.selectiverenderer.study.questionnaire.AnswerField;
import org.selectiverenderer.study.questionnaire.ChoiceOption;
import org.selectiverenderer.study.questionnaire.NumberKeys;
import org.selectiverenderer.swing.PlainText;

/**
 * Shows a choice: as toggle buttons side by side between the labels of the ends, or as a vertical
 * list if the labels are long.
 */
final class ChoiceView implements FieldView {
  /**
   * Colours of a chosen button, which must be seen from the chair; the grey of the look and feel
   * has too little contrast.
   */
  private static final String CHOSEN = "selectedBackground:#1f66b5; selectedForeground:#ffffff";

  /**
   * How long a digit waits for a second one, in milliseconds; the messages to participants say it,
   * too.
   */
  static final int SECOND_DIGIT_MS = 1500;

  private static final int PICTURES_ABREAST = 4;

  private final AnswerField.Choice field;
  private final Listener listener;
  private final JPanel panel = new JPanel();
  private final List<JToggleButton> buttons = new ArrayList<>();
  private final ButtonGroup group = new ButtonGroup();
  private final Optional<NumberKeys> numbers;
  private final Timer wait = new Timer(SECOND_DIGIT_MS, event -> settle());
  private NumberKeys typed;

  /** The last answer that does not wait for a digit. */
  private String known = "";

  /**
   * @param id id of the question, for the names of the buttons
   * @param asked the question's text, for the accessible names of the buttons
   */
  ChoiceView(
      AnswerField.Choice field,
      String id,
      String asked,
      QuestionRowLayout shape,
      Listener listener) {
    this.field = field;
    this.listener = listener;
    numbers = NumberKeys.of(field);
    typed = numbers.orElse(new NumberKeys(List.of(), ""));
    wait.setRepeats(false);
    panel.setOpaque(false);
    if (field.pictured()) {
      panel.setLayout(new GridLayout(0, Math.min(PICTURES_ABREAST, field.options().size()), 8, 8));
      field.options().forEach(option -> panel.add(named(pictured(option), option, id, asked)));
    } else if (list(field)) {
      panel.setLayout(new BoxLayout(panel, BoxLayout.Y_AXIS));
      field.options().forEach(option -> panel.add(named(listed(option), option, id, asked)));
    } else {
      panel.setLayout(new FlowLayout(FlowLayout.LEFT, QuestionRowLayout.GAP, 0));
      boolean ends = shape.beside() || !field.least().isEmpty() || !field.most().isEmpty();
      end(field.least(), ends ? shape.least() : 0, SwingConstants.RIGHT);
      field.options().forEach(option -> panel.add(inLine(option, id, asked, shape)));
      end(field.most(), ends ? shape.most() : 0, SwingConstants.LEFT);
    }
    panel.setAlignmentX(0);
  }

  /** Returns whether the options are laid out as a vertical list. */
  static boolean list(AnswerField.Choice field) {
    return field.several() || !field.inLine();
  }

  private void end(String text, int width, int side) {
    if (width > 0) {
      panel.add(QuestionRowLayout.end(text, width, side));
    }
  }

  private JComponent inLine(ChoiceOption option, String id, String asked, QuestionRowLayout shape) {
    JToggleButton button = named(QuestionRowLayout.button(option), option, id, asked);
    button.putClientProperty(FlatClientProperties.STYLE, CHOSEN);
    button.setPreferredSize(
        new Dimension(QuestionRowLayout.width(field, button), QuestionRowLayout.BUTTON_HEIGHT));
    if (option.note().isEmpty()) {
      return button;
    }
    if (shape.notesAbove()) {
      button.setToolTipText(PlainText.of(option.note()));
      return button;
    }
    JPanel noted = new JPanel(new BorderLayout());
    noted.setOpaque(false);
    noted.add(button, BorderLayout.NORTH);
    noted.add(
        QuestionRowLayout.note(option.note(), QuestionRowLayout.width(field, button)),
        BorderLayout.CENTER);
    return noted;
  }

  private static JToggleButton pictured(ChoiceOption option) {
    JToggleButton button = new HiDpiComponents.Button("");
    button.setIcon(new PictureIcon(option.picture().orElseThrow()));
    button.putClientProperty(FlatClientProperties.STYLE, CHOSEN);
    return button;
  }

  private JToggleButton listed(ChoiceOption option) {
    JToggleButton button =
        field.several()
            ? new HiDpiComponents.CheckBox(option.label())
            : new HiDpiComponents.RadioButton(option.label());
    button.setFont(button.getFont().deriveFont(Font.PLAIN, 15f));
    button.setBorder(BorderFactory.createEmptyBorder(4, 4, 4, 4));
    button.setIconTextGap(10);
    button.setOpaque(false);
    button.setAlignmentX(0);
    return button;
  }

  private <T extends JToggleButton> T named(
      T button, ChoiceOption option, String id, String asked) {
    button.getAccessibleContext().setAccessibleName(asked + ": " + option.label());
    button.setName(id + ":" + option.value());
    button.setActionCommand(option.value());
    button.setFocusable(false); // The window has the keys.
    if (!field.several()) {
      group.add(button);
    }
    button.addActionListener(event -> chosen());
    buttons.add(button);
    return button;
  }

  private void chosen() {
    wait.stop();
    typed = typed.none();
    if (numbers.isPresent()) {
      listener.filled(value(), false); // The time is that of the mouse, not of a key before it.
    }
    told();
  }

  private void told() {
    wait.stop();
    typed = typed.none();
    listener.filled(value(), true);
  }

  private String value() {
    return field.joined(
        buttons.stream()
            .filter(JToggleButton::isSelected)
            .map(JToggleButton::getActionCommand)
            .toList());
  }

  @Override
  public JComponent component() {
    return panel;
  }

  @Override
  public void show(String value) {
    known = value;
    select(value);
  }

  private void select(String value) {
    List<String> chosen = AnswerField.Choice.parts(value);
    if (chosen.isEmpty()) {
      group.clearSelection();
    }
    buttons.forEach(button -> button.setSelected(chosen.contains(button.getActionCommand())));
  }

  @Override
  public boolean key(char key) {
    if (numbers.isPresent()) {
      return number(key);
    }
    String lower = String.valueOf(key).toLowerCase(Locale.ROOT);
    for (int i = 0; i < buttons.size(); i++) {
      if (field.options().get(i).keys().contains(lower)) {
        buttons.get(i).setSelected(!field.several() || !buttons.get(i).isSelected());
        told();
        return true;
      }
    }
    return false;
  }

  /** Handles a key of a number: shows the number so far, which counts when it waits no more. */
  private boolean number(char key) {
    if (!typed.takes(key)) {
      return waits(); // A key that the scale has not must not answer anything else meanwhile.
    }
    typed = typed.and(key);
    String shown = typed.value().orElse(known);
    select(shown);
    listener.filled(shown, false);
    if (typed.waits()) {
      wait.restart();
    } else {
      told();
    }
    return true;
  }

  @Override
  public boolean waits() {
    return typed.waits();
  }

  @Override
  public boolean advances() {
    return !field.several();
  }

  @Override
  public void focus() {
    // The window has the keys.
  }

  @Override
  public boolean takesText() {
    return false;
  }

  @Override
  public void settle() {
    if (waits()) {
      boolean number = typed.value().isPresent();
      wait.stop();
      typed = typed.none();
      if (number) {
        told();
      }
    }
  }

  /** Returns the space between two fields of a row. */
  static JComponent gap() {
    return (JComponent) Box.createHorizontalStrut(QuestionRowLayout.FIELD_GAP);
  }
}
