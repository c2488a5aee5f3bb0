package org.selectiverenderer.experiment.window;

import java.awt.Color;
import java.awt.Component;
import java.awt.Dimension;
import java.util.ArrayList;
import java.util.List;
import javax.swing.BorderFactory;
import javax.swing.Box;
import javax.swing.BoxLayout;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import org.selectiverenderer.experiment.questionnaire.Answer;
import org.selectiverenderer.experiment.questionnaire.AnswerField;
import org.selectiverenderer.experiment.questionnaire.Question;
import org.selectiverenderer.experiment.questionnaire.Wording;

/** A question and its fields, as a row. Knows fields, and no kinds of questions. */
final class QuestionRow {
  private static final Color CURRENT = new Color(0xe3eefc);
  static final Color PLAIN = Color.WHITE;

  /** Hears what becomes of the row. */
  interface Listener {
    /**
     * The answer is another one.
     *
     * @param settled whether it may be kept as it is: not while somebody is typing
     */
    void answered(QuestionRow row, Answer answer, boolean settled);

    /** Somebody turns to it. */
    void touched(QuestionRow row);
  }

  private final Question question;
  private final Wording wording;
  private final Listener listener;
  private final JPanel panel = new JPanel();
  private final List<FieldView> views = new ArrayList<>();
  private Answer answer;

  /**
   * @param known the answer so far
   */
  QuestionRow(
      Question question,
      Answer known,
      Wording wording,
      RowShape shape,
      int width,
      Listener listener) {
    this.question = question;
    this.wording = wording;
    this.listener = listener;
    answer = known;
    panel.setAlignmentX(0);
    List<AnswerField> fields = question.kind().fields(wording);
    for (AnswerField field : fields) {
      views.add(view(field, shape, views.isEmpty()));
    }
    if (shape.beside()) {
      layBeside(shape);
    } else {
      layBelow(width);
    }
    show();
    current(false);
  }

  private FieldView view(AnswerField field, RowShape shape, boolean first) {
    FieldView.Listener told =
        (value, settled) ->
            change(
                first
                    ? answer.value(value)
                    : answer.confidence(value.isEmpty() ? 0 : Integer.parseInt(value)),
                settled);
    if (field instanceof AnswerField.Line line) {
      return new LineView(line, question.id(), spoken(), told, () -> listener.touched(this));
    }
    return new ChoiceView((AnswerField.Choice) field, question.id(), spoken(), shape, told);
  }

  /** What is asked, for people who hear it. */
  private String spoken() {
    AnswerField first = question.kind().fields(wording).get(0);
    return question.text().isEmpty() && first instanceof AnswerField.Choice choice
        ? choice.least() + " - " + choice.most()
        : question.text();
  }

  private void layBeside(RowShape shape) {
    panel.setLayout(new BoxLayout(panel, BoxLayout.X_AXIS));
    panel.setBorder(BorderFactory.createEmptyBorder(5, 12, 5, 12));
    panel.add(Box.createRigidArea(new Dimension(0, RowShape.BUTTON_HEIGHT)));
    if (shape.name() == 0) {
      panel.add(Box.createHorizontalGlue()); // Nothing to read but the ends: in the middle.
    } else {
      JLabel name = new ScreenText.Label();
      name.setFont(name.getFont().deriveFont(16f));
      boolean fits =
          name.getFontMetrics(name.getFont()).stringWidth(question.text()) <= shape.name() - 8;
      name.setText(
          fits
              ? question.text()
              : RowShape.wrapped(question.text(), shape.name() - 8, JLabel.LEFT));
      Dimension size =
          new Dimension(
              shape.name(), Math.max(RowShape.BUTTON_HEIGHT, name.getPreferredSize().height));
      name.setPreferredSize(size);
      name.setMinimumSize(size);
      name.setMaximumSize(size);
      panel.add(name);
    }
    for (int i = 0; i < views.size(); i++) {
      if (i > 0) {
        panel.add(ChoiceView.gap());
      }
      JComponent view = views.get(i).component();
      view.setMaximumSize(view.getPreferredSize());
      panel.add(view);
    }
    panel.add(Box.createHorizontalGlue());
  }

  private void layBelow(int width) {
    panel.setLayout(new BoxLayout(panel, BoxLayout.Y_AXIS));
    panel.setBorder(BorderFactory.createEmptyBorder(10, 12, 10, 12));
    if (!question.text().isEmpty()) {
      JComponent text = WrappedText.of(question.text(), 16f, width);
      text.setAlignmentX(0);
      panel.add(text);
      panel.add(Box.createVerticalStrut(6));
    }
    for (FieldView view : views) {
      view.component().setMaximumSize(view.component().getPreferredSize());
      view.component().setAlignmentX(Component.LEFT_ALIGNMENT);
      panel.add(view.component());
    }
  }

  private void change(Answer other, boolean settled) {
    answer = other;
    if (settled) {
      show();
    }
    listener.answered(this, answer, settled);
  }

  private void show() {
    views.get(0).show(answer.value());
    if (views.size() > 1) {
      views.get(1).show(answer.confidence() > 0 ? Integer.toString(answer.confidence()) : "");
    }
  }

  /**
   * A character was typed while the row is current.
   *
   * @return whether it was an answer
   */
  boolean key(char typed) {
    return views.stream().anyMatch(view -> view.key(typed));
  }

  /** Marks the row that keys answer. */
  void current(boolean on) {
    panel.setBackground(on ? CURRENT : PLAIN);
  }

  /** Takes the keys that are typed, where it takes any. */
  void focus() {
    views.forEach(FieldView::focus);
  }

  /** Whether keys are typed into it. */
  boolean takesText() {
    return views.stream().anyMatch(FieldView::takesText);
  }

  /** Whether an answer is all there is to it, so that the next row may follow at once. */
  boolean settlesAtOnce() {
    return question.kind().fields(wording).stream()
        .allMatch(field -> field instanceof AnswerField.Choice choice && !choice.several());
  }

  /** Tells of what was typed and not yet told. */
  void settle() {
    views.forEach(FieldView::settle);
  }

  /** Whether nothing more can be answered: one that may be left out is open until it is. */
  boolean answered() {
    return question.complete(answer, wording) && !answer.equals(Answer.NONE);
  }

  Question question() {
    return question;
  }

  JPanel panel() {
    return panel;
  }
}
