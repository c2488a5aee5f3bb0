package org.selectiverenderer.app.window;

import java.awt.Color;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.List;
import javax.swing.BorderFactory;
import javax.swing.Box;
import javax.swing.BoxLayout;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import org.selectiverenderer.study.questionnaire.Answer;
import org.selectiverenderer.study.questionnaire.AnswerField;
import org.selectiverenderer.study.questionnaire.ParticipantMessages;
import org.selectiverenderer.study.questionnaire.Question;
import org.selectiverenderer.study.questionnaire.RankingField;
import org.selectiverenderer.study.questionnaire.SliderField;
import org.selectiverenderer.swing.PlainText;

/** The row of a question with its fields. Depends on fields, not on kinds of questions. */
final class QuestionRow {
  private static final Color CURRENT = new Color(0xe3eefc);
  static final Color PLAIN = Color.WHITE;

  /** Receives the events of a row. */
  interface Listener {
    /**
     * The answer has changed.
     *
     * @param settled whether the answer is final; false while the participant is typing
     */
    void answered(QuestionRow row, Answer answer, boolean settled);

    /** The participant clicked into the row. */
    void touched(QuestionRow row);
  }

  private final Question question;
  private final ParticipantMessages wording;
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
      ParticipantMessages wording,
      QuestionRowLayout shape,
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

  private FieldView view(AnswerField field, QuestionRowLayout shape, boolean first) {
    FieldView.Listener told =
        (value, settled) ->
            change(
                first
                    ? answer.value(value)
                    : answer.confidence(value.isEmpty() ? 0 : Integer.parseInt(value)),
                settled);
    if (field instanceof AnswerField.Line line) {
      return new TextFieldView(line, question.id(), spoken(), told, () -> listener.touched(this));
    }
    if (field instanceof SliderField slider) {
      return new SliderView(slider, question.id(), spoken(), shape, told);
    }
    if (field instanceof RankingField ranking) {
      return new RankingView(ranking, question.id(), spoken(), told);
    }
    return new ChoiceView((AnswerField.Choice) field, question.id(), spoken(), shape, told);
  }

  /** Returns the accessible name of the question. */
  private String spoken() {
    AnswerField first = question.kind().fields(wording).get(0);
    if (!question.text().isEmpty()) {
      return question.text();
    }
    if (first instanceof SliderField slider) {
      return slider.least() + " - " + slider.most();
    }
    return first instanceof AnswerField.Choice choice ? choice.least() + " - " + choice.most() : "";
  }

  private void layBeside(QuestionRowLayout shape) {
    panel.setLayout(new BoxLayout(panel, BoxLayout.X_AXIS));
    panel.setBorder(BorderFactory.createEmptyBorder(5, 12, 5, 12));
    panel.add(Box.createRigidArea(new Dimension(0, QuestionRowLayout.BUTTON_HEIGHT)));
    if (shape.name() == 0) {
      panel.add(Box.createHorizontalGlue()); // Without a question text, centre the scale.
    } else {
      JLabel name = new HiDpiComponents.Label();
      name.setFont(name.getFont().deriveFont(16f));
      boolean fits =
          name.getFontMetrics(name.getFont()).stringWidth(question.text()) <= shape.name() - 8;
      name.setText(
          fits
              ? PlainText.of(question.text())
              : QuestionRowLayout.wrapped(question.text(), shape.name() - 8, JLabel.LEFT));
      Dimension size =
          new Dimension(
              shape.name(),
              Math.max(QuestionRowLayout.BUTTON_HEIGHT, name.getPreferredSize().height));
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
      JComponent text = WrappedTextArea.of(question.text(), 16f, width);
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
   * Handles a character that was typed while the row is current.
   *
   * @return whether the character chose an option
   */
  boolean key(char typed) {
    return views.stream().anyMatch(view -> view.key(typed));
  }

  /** Handles a key that was pressed while the row is current; returns whether a field has. */
  boolean pressed(KeyEvent key) {
    return views.stream().anyMatch(view -> view.pressed(key));
  }

  /** Sets whether this row is current, so that keys answer it. */
  void current(boolean on) {
    panel.setBackground(on ? CURRENT : PLAIN);
  }

  /** Takes the keyboard focus if a field takes text. */
  void focus() {
    views.forEach(FieldView::focus);
  }

  /** Returns whether a field takes text. */
  boolean takesText() {
    return views.stream().anyMatch(FieldView::takesText);
  }

  /**
   * Returns whether one answer completes the row, so that the next row may become current at once.
   */
  boolean settlesAtOnce() {
    return views.stream().allMatch(FieldView::advances);
  }

  /** Returns whether a field waits for a second digit of a number. */
  boolean waits() {
    return views.stream().anyMatch(FieldView::waits);
  }

  /** Reports text that was typed and is not reported yet. */
  void settle() {
    views.forEach(FieldView::settle);
  }

  /**
   * Returns whether the question has a complete answer; an optional question without one is open.
   */
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
