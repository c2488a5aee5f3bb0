package org.selectiverenderer.app.window;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Insets;
import java.util.List;
import java.util.function.Function;
import javax.swing.BorderFactory;
import javax.swing.Box;
import javax.swing.BoxLayout;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JToggleButton;
import javax.swing.SwingConstants;
import org.selectiverenderer.base.markup.MarkupEscaper;
import org.selectiverenderer.study.questionnaire.AnswerField;
import org.selectiverenderer.study.questionnaire.ChoiceOption;
import org.selectiverenderer.study.questionnaire.ParticipantMessages;
import org.selectiverenderer.study.questionnaire.Question;
import org.selectiverenderer.study.questionnaire.QuestionnairePage;
import org.selectiverenderer.study.questionnaire.SliderField;
import org.selectiverenderer.swing.PlainText;

/**
 * Layout metrics that all rows of a page share, in pixels, so that their buttons are aligned in
 * columns.
 *
 * @param beside whether a question's text is beside its fields; if not, it is above them
 * @param name width of the texts beside the fields; 0 if there are none
 * @param least width of the labels before the first option; 0 if no row has one
 * @param most width of the labels after the last option; 0 if no row has one
 * @param notesAbove whether the notes of the options are shown once, above all rows
 */
record QuestionRowLayout(boolean beside, int name, int least, int most, boolean notesAbove) {
  static final int GAP = 4;
  static final int FIELD_GAP = 36;
  static final int BUTTON_HEIGHT = 32;
  private static final int NUMBER_WIDTH = 46;
  private static final int NUMBER_MARGIN = 6;
  private static final int NOTED_WIDTH = 78;
  private static final int NAME_WIDTH = 260;
  private static final int MOST_NAME_WIDTH = 480;
  private static final int ROW_WIDTH = 880;
  private static final int END_WIDTH = 200;
  private static final int LINES_APART = 12;

  /** Maximum length in characters of a text beside the fields. */
  private static final int BESIDE = 46;

  /** Computes the metrics of a page. */
  static QuestionRowLayout of(QuestionnairePage page, ParticipantMessages wording) {
    List<Question> questions = page.questions();
    List<AnswerField> fields =
        questions.stream().flatMap(question -> question.kind().fields(wording).stream()).toList();
    boolean lines =
        fields.stream()
            .allMatch(
                field -> field instanceof AnswerField.Choice choice && !ChoiceView.list(choice));
    boolean grid = questions.stream().noneMatch(question -> question.kind().grid().isEmpty());
    boolean beside =
        lines
            && (grid
                || questions.stream().allMatch(question -> question.text().length() <= BESIDE));
    boolean named = questions.stream().anyMatch(question -> !question.text().isEmpty());
    boolean alike =
        lines
            && questions.size() > 1
            && questions.stream()
                    .map(
                        question ->
                            question.kind().fields(wording).stream()
                                .map(field -> ((AnswerField.Choice) field).options())
                                .toList())
                    .distinct()
                    .count()
                == 1;
    return new QuestionRowLayout(
        beside,
        beside && named ? grid ? statements(fields) : NAME_WIDTH : 0,
        ends(fields, AnswerField.Choice::least, SliderField::least),
        ends(fields, AnswerField.Choice::most, SliderField::most),
        alike);
  }

  /** Returns the width of the statements of a grid: what its buttons leave. */
  private static int statements(List<AnswerField> fields) {
    int buttons =
        fields.get(0) instanceof AnswerField.Choice choice
            ? choice.options().stream()
                .mapToInt(option -> width(choice, button(option)) + GAP)
                .sum()
            : 0;
    return Math.max(NAME_WIDTH, Math.min(MOST_NAME_WIDTH, ROW_WIDTH - buttons));
  }

  private static int ends(
      List<AnswerField> fields,
      Function<AnswerField.Choice, String> end,
      Function<SliderField, String> ofSlider) {
    JLabel label = new HiDpiComponents.Label();
    FontMetrics metrics = label.getFontMetrics(label.getFont());
    return fields.stream()
        .map(
            field ->
                field instanceof AnswerField.Choice choice && !ChoiceView.list(choice)
                    ? end.apply(choice)
                    : field instanceof SliderField slider ? ofSlider.apply(slider) : "")
        .filter(text -> !text.isEmpty())
        .mapToInt(text -> Math.min(END_WIDTH, metrics.stringWidth(text) + 8))
        .max()
        .orElse(0);
  }

  /** Returns the label of an end of a scale or slider. */
  static JLabel end(String text, int width, int side) {
    JLabel label = new HiDpiComponents.Label();
    label.setText(wrapped(text, width, side));
    label.setHorizontalAlignment(side);
    Dimension size = label.getPreferredSize();
    label.setPreferredSize(new Dimension(width, size.height));
    return label;
  }

  /** Returns the button of an option; a number has narrow margins, so that long scales fit. */
  static JToggleButton button(ChoiceOption option) {
    JToggleButton button = new HiDpiComponents.Button(option.label());
    if (number(option)) {
      button.setMargin(new Insets(2, NUMBER_MARGIN, 2, NUMBER_MARGIN));
    }
    return button;
  }

  private static boolean number(ChoiceOption option) {
    return option.label().matches("-?\\d{1,3}");
  }

  /** Returns the width of the widest number with its margins. */
  private static int widestNumber(AnswerField.Choice field) {
    return field.options().stream()
        .map(QuestionRowLayout::button)
        .mapToInt(
            button -> {
              Insets around = button.getInsets();
              int text = button.getFontMetrics(button.getFont()).stringWidth(button.getText());
              return text + around.left + around.right + 2;
            })
        .max()
        .orElse(0);
  }

  /** Returns the width of an option's button; those of numbers are equally wide. */
  static int width(AnswerField.Choice field, JToggleButton button) {
    boolean numbers = field.options().stream().allMatch(QuestionRowLayout::number);
    boolean noted = field.options().stream().anyMatch(option -> !option.note().isEmpty());
    if (noted) {
      return numbers
          ? Math.max(NOTED_WIDTH, widestNumber(field))
          : Math.max(NOTED_WIDTH, button.getPreferredSize().width);
    }
    return numbers
        ? Math.max(NUMBER_WIDTH, widestNumber(field))
        : Math.max(64, button.getPreferredSize().width);
  }

  /** Returns a text that wraps at a width. */
  static String wrapped(String text, int width, int side) {
    String align =
        side == SwingConstants.RIGHT ? "right" : side == SwingConstants.CENTER ? "center" : "left";
    JLabel label = new HiDpiComponents.Label();
    boolean fits = label.getFontMetrics(label.getFont()).stringWidth(text) <= width;
    return fits
        ? PlainText.of(text)
        : "<html><div style='width:%dpx;text-align:%s'>%s</div>"
            .formatted(htmlPixels(width), align, MarkupEscaper.text(text));
  }

  /**
   * Converts pixels to Swing's HTML pixels, which are 4/3 as large: it renders CSS pixels of 96 to
   * the inch at 72.
   */
  private static int htmlPixels(int pixels) {
    return pixels * 3 / 4;
  }

  /** Returns the note of an option in small letters. */
  static JLabel note(String text, int width) {
    JLabel label = new HiDpiComponents.Label();
    Font small = label.getFont().deriveFont(label.getFont().getSize2D() - 1.5f);
    label.setFont(small);
    label.setText(
        "<html><div style='width:%dpx;text-align:center'>%s</div>"
            .formatted(htmlPixels(width - 4), MarkupEscaper.text(text)));
    label.setHorizontalAlignment(SwingConstants.CENTER);
    label.setVerticalAlignment(SwingConstants.BOTTOM);
    label.setPreferredSize(new Dimension(width, label.getPreferredSize().height));
    return label;
  }

  /** Returns the headings above the columns of all rows; an empty panel without headings. */
  JComponent heading(QuestionnairePage page, ParticipantMessages wording) {
    JPanel line = new JPanel();
    List<String> titles = page.headings(wording);
    if (page.questions().isEmpty() || titles.isEmpty() && !notesAbove) {
      return line;
    }
    line.setLayout(new BoxLayout(line, BoxLayout.X_AXIS));
    line.setBorder(BorderFactory.createEmptyBorder(6, LINES_APART, 6, LINES_APART));
    line.add(Box.createHorizontalStrut(beside ? name : 0));
    List<AnswerField> fields = page.questions().get(0).kind().fields(wording);
    boolean said = !titles.isEmpty();
    for (int i = 0; i < fields.size(); i++) {
      if (i > 0) {
        line.add(ChoiceView.gap());
      }
      if (fields.get(i) instanceof AnswerField.Choice choice) {
        JComponent column = column(choice, i < titles.size() ? titles.get(i) : "");
        said |= choice.options().stream().anyMatch(option -> !option.note().isEmpty());
        line.add(column);
      }
    }
    line.add(Box.createHorizontalGlue());
    return said ? line : new JPanel();
  }

  private JComponent column(AnswerField.Choice choice, String title) {
    JPanel column = new JPanel();
    column.setLayout(new BoxLayout(column, BoxLayout.Y_AXIS));
    column.setAlignmentY(Component.BOTTOM_ALIGNMENT);
    int buttons =
        choice.options().stream().mapToInt(option -> width(choice, button(option)) + GAP).sum();
    int whole = buttons + GAP + (least > 0 ? least + GAP : 0) + (most > 0 ? most + GAP : 0);
    if (!title.isEmpty()) {
      JLabel label = new HiDpiComponents.Label();
      label.setFont(label.getFont().deriveFont(Font.BOLD));
      boolean fits = label.getFontMetrics(label.getFont()).stringWidth(title) <= whole - GAP;
      label.setText(
          fits
              ? PlainText.of(title)
              : "<html><div style='width:%dpx'>%s</div>"
                  .formatted(htmlPixels(whole - GAP), MarkupEscaper.text(title)));
      label.setAlignmentX(0);
      label.setBorder(BorderFactory.createEmptyBorder(0, GAP, 3, 0));
      column.add(label);
    }
    if (choice.options().stream().anyMatch(option -> !option.note().isEmpty())) {
      JPanel notes = new JPanel(new java.awt.FlowLayout(java.awt.FlowLayout.LEFT, GAP, 0));
      notes.setAlignmentX(0);
      if (least > 0) {
        notes.add(Box.createHorizontalStrut(least));
      }
      for (ChoiceOption option : choice.options()) {
        notes.add(note(option.note(), width(choice, button(option))));
      }
      column.add(notes);
    }
    Dimension size = new Dimension(whole, column.getPreferredSize().height);
    column.setPreferredSize(size);
    column.setMaximumSize(size);
    column.setMinimumSize(size);
    return column;
  }
}
