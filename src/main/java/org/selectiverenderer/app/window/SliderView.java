package org.selectiverenderer.app.window;

import java.awt.Dimension;
import java.awt.FlowLayout;
import java.awt.Font;
import java.awt.event.KeyEvent;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.SwingConstants;
import javax.swing.Timer;
import org.selectiverenderer.study.questionnaire.NumberKeys;
import org.selectiverenderer.study.questionnaire.SliderField;
import org.selectiverenderer.swing.PlainText;

/**
 * Shows a slider between the labels of its ends. A value is reported as final when the mouse is
 * released, when the keys rest, or when a number has all its digits.
 */
final class SliderView implements FieldView {
  /** Milliseconds without a key after which a moved thumb is final. */
  private static final int REST = 800;

  private static final int TRACK = 460;
  private static final int LONG_TRACK = 620;
  private static final int NUMBER = 70;

  private final SliderField field;
  private final Listener listener;
  private final JPanel panel =
      new JPanel(new FlowLayout(FlowLayout.LEFT, QuestionRowLayout.GAP, 0));
  private final SliderTrack track;
  private final JLabel number = new HiDpiComponents.Label();
  private final Optional<NumberKeys> numbers;
  private final Timer rest = new Timer(REST, event -> settle());
  private NumberKeys typed;
  private String known = "";
  private boolean open;
  private boolean byNumber;

  /**
   * @param asked the question's text, for the accessible name
   */
  SliderView(
      SliderField field, String id, String asked, QuestionRowLayout shape, Listener listener) {
    this.field = field;
    this.listener = listener;
    numbers = NumberKeys.of(field);
    typed = numbers.orElse(new NumberKeys(List.of(), ""));
    rest.setRepeats(false);
    boolean ends = shape.least() > 0 || shape.most() > 0;
    track = new SliderTrack(field, ends ? TRACK : LONG_TRACK, this::moved);
    track.setName(id);
    track.getAccessibleContext().setAccessibleName(asked);
    panel.setOpaque(false);
    panel.setAlignmentX(0);
    end(field.least(), shape.least(), SwingConstants.RIGHT);
    panel.add(track);
    end(field.most(), shape.most(), SwingConstants.LEFT);
    if (field.number()) {
      number.setFont(number.getFont().deriveFont(Font.BOLD, 16f));
      number.setHorizontalAlignment(SwingConstants.CENTER);
      number.setPreferredSize(
          new Dimension(NUMBER, number.getFontMetrics(number.getFont()).getHeight()));
      panel.add(number);
    }
    show("");
  }

  private void end(String text, int width, int side) {
    if (width > 0) {
      panel.add(QuestionRowLayout.end(text, width, side));
    }
  }

  private void moved(int position, boolean dropped) {
    typed = typed.none();
    byNumber = false;
    fill(field.value(position));
    if (dropped) {
      settle();
    }
  }

  /** Shows a value that may still change. */
  private void fill(String value) {
    known = value;
    open = true;
    draw();
    listener.filled(value, false);
  }

  private void draw() {
    OptionalInt answered = known.isEmpty() ? OptionalInt.empty() : field.position(known);
    track.show(answered.isPresent() ? answered : field.start(), answered.isPresent());
    number.setText(PlainText.of(known.isEmpty() ? "\u2013" : known));
  }

  @Override
  public JComponent component() {
    return panel;
  }

  @Override
  public void show(String value) {
    known = value;
    draw();
  }

  @Override
  public boolean pressed(KeyEvent key) {
    OptionalInt now = known.isEmpty() ? field.start() : field.position(known);
    switch (key.getKeyCode()) {
      case KeyEvent.VK_RIGHT, KeyEvent.VK_KP_RIGHT -> step(field.moved(now, 1));
      case KeyEvent.VK_LEFT, KeyEvent.VK_KP_LEFT -> step(field.moved(now, -1));
      case KeyEvent.VK_PAGE_UP -> step(field.moved(now, field.page()));
      case KeyEvent.VK_PAGE_DOWN -> step(field.moved(now, -field.page()));
      case KeyEvent.VK_HOME -> step(0);
      case KeyEvent.VK_END -> step(field.last());
      case KeyEvent.VK_SPACE -> {
        if (now.isPresent()) {
          step(now.getAsInt()); // Takes the thumb where it stands.
        }
      }
      default -> {
        return false;
      }
    }
    return true;
  }

  private void step(int position) {
    moved(position, false);
    rest.setInitialDelay(REST);
    rest.restart();
  }

  @Override
  public boolean key(char key) {
    char digit = key == ',' ? '.' : key;
    if (numbers.isEmpty() || !typed.takes(digit)) {
      return waits(); // A key that the slider has not must not answer anything else meanwhile.
    }
    typed = typed.and(digit);
    Optional<String> value = typed.value();
    value.ifPresent(this::fill);
    byNumber = true;
    if (typed.waits()) {
      rest.setInitialDelay(ChoiceView.SECOND_DIGIT_MS);
      rest.restart();
    } else {
      settle();
    }
    return true;
  }

  @Override
  public boolean waits() {
    return typed.waits();
  }

  @Override
  public boolean advances() {
    return byNumber;
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
    rest.stop();
    typed = typed.none();
    if (open) {
      open = false;
      listener.filled(known, true);
    }
  }
}
