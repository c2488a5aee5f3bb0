package org.selectiverenderer.experiment.window;

import com.formdev.flatlaf.FlatClientProperties;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.FlowLayout;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.Box;
import javax.swing.BoxLayout;
import javax.swing.ButtonGroup;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JToggleButton;
import org.selectiverenderer.experiment.questionnaire.Answer;
import org.selectiverenderer.experiment.questionnaire.QuestionItem;
import org.selectiverenderer.experiment.questionnaire.Wording;
import org.selectiverenderer.experiment.study.QuestionKind;

/** One object of a questionnaire and its choices, as a row. */
final class QuestionRow {
  private static final Color CURRENT = new Color(0xe3eefc);
  static final Color PLAIN = Color.WHITE;
  private static final int NAME_WIDTH = 260;

  /** An answer must be seen from the chair: the look and feel's own grey is hardly seen. */
  private static final String CHOSEN = "selectedBackground:#1f66b5; selectedForeground:#ffffff";

  private final QuestionKind kind;
  private final QuestionItem item;
  private final BiConsumer<QuestionItem, Answer> listener;
  private final JPanel panel = new JPanel();
  private final List<JToggleButton> values = new ArrayList<>();
  private final List<JToggleButton> levels = new ArrayList<>();
  private Answer answer;

  /**
   * @param known the answer so far
   * @param listener hears every change, and the row that it is in
   */
  QuestionRow(
      QuestionKind kind,
      QuestionItem item,
      Answer known,
      Wording wording,
      BiConsumer<QuestionItem, Answer> listener) {
    this.kind = kind;
    this.item = item;
    this.listener = listener;
    answer = known;
    panel.setLayout(new BoxLayout(panel, BoxLayout.X_AXIS));
    panel.setBorder(BorderFactory.createEmptyBorder(6, 12, 6, 12));
    JLabel name = new JLabel(wording.name(item));
    name.setFont(name.getFont().deriveFont(16f));
    name.setPreferredSize(new Dimension(NAME_WIDTH, 30));
    name.setMinimumSize(name.getPreferredSize());
    name.setMaximumSize(name.getPreferredSize());
    panel.add(name);
    panel.setAlignmentX(0);
    if (kind == QuestionKind.RECOGNITION) {
      panel.add(choices(values, List.of("yes", "no"), wording, this::value));
      panel.add(Box.createHorizontalStrut(40));
      panel.add(
          choices(
              levels,
              List.of("1", "2", "3", "4", "5"),
              wording,
              level -> confidence(Integer.parseInt(level))));
    } else {
      panel.add(new JLabel(wording.of("expectancy.least") + " "));
      panel.add(choices(values, List.of("1", "2", "3", "4", "5", "6"), wording, this::value));
      panel.add(new JLabel(" " + wording.of("expectancy.most") + "  "));
    }
    panel.add(Box.createHorizontalGlue());
    show();
    current(false);
  }

  /** What stands over the rows' columns. */
  static JPanel heading(QuestionKind kind, Wording wording) {
    JPanel line = new JPanel(new FlowLayout(FlowLayout.LEFT, 0, 4));
    line.setBorder(BorderFactory.createEmptyBorder(0, 16, 0, 12));
    line.add(column("", NAME_WIDTH));
    if (kind == QuestionKind.RECOGNITION) {
      line.add(column(wording.of("recognition.question"), 180));
      line.add(column(wording.of("recognition.confidence"), 300));
    } else {
      line.add(column(wording.of("expectancy.question"), 300));
    }
    return line;
  }

  private static JLabel column(String text, int width) {
    JLabel label = new JLabel(text);
    label.setPreferredSize(new Dimension(width, 20));
    return label;
  }

  private JPanel choices(
      List<JToggleButton> buttons, List<String> keys, Wording wording, Consumer<String> chosen) {
    JPanel line = new JPanel(new FlowLayout(FlowLayout.LEFT, 4, 0));
    line.setOpaque(false);
    ButtonGroup group = new ButtonGroup();
    for (String key : keys) {
      boolean number = key.length() == 1;
      JToggleButton button = new JToggleButton(number ? key : wording.of(key));
      button.getAccessibleContext().setAccessibleName(wording.name(item) + ": " + button.getText());
      button.setName(item.object() + ":" + key);
      button.setActionCommand(key);
      button.setFocusable(false); // The window has the keys.
      button.putClientProperty(FlatClientProperties.STYLE, CHOSEN);
      button.setPreferredSize(new Dimension(number ? 44 : 64, 30));
      if (number && kind == QuestionKind.RECOGNITION) {
        button.setToolTipText(wording.of("recognition.confidence." + key));
      }
      button.addActionListener(event -> chosen.accept(key));
      group.add(button);
      buttons.add(button);
      line.add(button);
    }
    line.setMaximumSize(line.getPreferredSize());
    return line;
  }

  private void value(String value) {
    change(answer.value(value));
  }

  private void confidence(int level) {
    change(answer.confidence(level));
  }

  private void change(Answer other) {
    answer = other;
    show();
    listener.accept(item, answer);
  }

  private void show() {
    values.forEach(
        button -> {
          if (button.getActionCommand().equals(answer.value())) {
            button.setSelected(true);
          }
        });
    if (answer.confidence() > 0 && !levels.isEmpty()) {
      levels.get(answer.confidence() - 1).setSelected(true);
    }
  }

  /**
   * A key was pressed while the row is current.
   *
   * @return whether it was an answer
   */
  boolean key(char typed) {
    if (typed >= '1' && typed <= '9') {
      int number = typed - '0';
      if (kind == QuestionKind.EXPECTANCY && number <= 6) {
        value(Integer.toString(number));
        return true;
      }
      if (kind == QuestionKind.RECOGNITION && number <= 5) {
        confidence(number);
        return true;
      }
      return false;
    }
    // The Greek letters are on the same keys.
    boolean yes = "yYυΥ".indexOf(typed) >= 0;
    boolean no = "nNνΝ".indexOf(typed) >= 0;
    if (kind == QuestionKind.RECOGNITION && (yes || no)) {
      value(yes ? "yes" : "no");
      return true;
    }
    return false;
  }

  /** Marks the row that keys answer. */
  void current(boolean on) {
    panel.setBackground(on ? CURRENT : PLAIN);
  }

  boolean complete() {
    return answer.complete(kind == QuestionKind.RECOGNITION);
  }

  JPanel panel() {
    return panel;
  }
}
