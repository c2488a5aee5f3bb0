package org.selectiverenderer.app.window;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javax.swing.BorderFactory;
import javax.swing.BoxLayout;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.SwingUtilities;
import org.selectiverenderer.study.questionnaire.Answer;
import org.selectiverenderer.study.questionnaire.ParticipantMessages;
import org.selectiverenderer.study.questionnaire.Question;
import org.selectiverenderer.study.questionnaire.QuestionnairePage;
import org.selectiverenderer.study.questionnaire.QuestionnaireProgress;

/**
 * Shows the questions of a page as rows. Keys answer the current row; when it is complete, the next
 * open row becomes current. Records when each question comes into view.
 */
final class PagePanel implements QuestionRow.Listener {
  private final QuestionnairePage page;
  private final QuestionnaireProgress course;
  private final Runnable answered;
  private final List<QuestionRow> rows = new ArrayList<>();
  private final Map<QuestionRow, Long> typed = new HashMap<>();

  /** The rows under each text or heading, which is shown while one of them is. */
  private final Map<JComponent, List<QuestionRow>> headed = new HashMap<>();

  private final JScrollPane scroll;
  private int current;

  /**
   * @param course the progress, which receives answers and the questions in view
   * @param width available width in pixels
   * @param answered runs after each change of an answer
   */
  PagePanel(
      QuestionnairePage page,
      QuestionnaireProgress course,
      ParticipantMessages wording,
      int width,
      Runnable answered) {
    this.page = page;
    this.course = course;
    this.answered = answered;
    JPanel list = new JPanel();
    list.setOpaque(false);
    list.setLayout(new BoxLayout(list, BoxLayout.Y_AXIS));
    List<QuestionnairePage> parts = page.parts();
    for (QuestionnairePage part : parts) {
      QuestionRowLayout shape = QuestionRowLayout.of(part, wording);
      JComponent above =
          above(part, parts.size() > 1 || !part.stem().isEmpty(), shape, wording, width);
      if (above.getComponentCount() > 0) {
        list.add(above);
      }
      for (Question question : part.questions()) {
        QuestionRow row =
            new QuestionRow(question, course.answer(question), wording, shape, width, this);
        if (above.getComponentCount() > 0) {
          headed.merge(above, List.of(row), PagePanel::both);
        }
        add(row, list);
      }
    }
    JPanel top = new JPanel(new BorderLayout());
    top.setBackground(QuestionRow.PLAIN);
    top.add(list, BorderLayout.NORTH); // Few rows stay together at the top.
    scroll = new JScrollPane(top);
    scroll.setBorder(BorderFactory.createEmptyBorder());
    // For a monitor that is narrower than a row of buttons.
    scroll.setHorizontalScrollBarPolicy(JScrollPane.HORIZONTAL_SCROLLBAR_AS_NEEDED);
    if (parts.size() == 1 && page.stem().isEmpty()) {
      JComponent heading = QuestionRowLayout.of(page, wording).heading(page, wording);
      if (heading.getComponentCount() > 0) {
        scroll.setColumnHeaderView(heading);
      }
    }
    scroll.getVerticalScrollBar().setUnitIncrement(24);
    scroll.getViewport().addChangeListener(event -> look());
    ask();
  }

  private void add(QuestionRow row, JPanel list) {
    int number = rows.size();
    row.panel()
        .addMouseListener(
            new MouseAdapter() {
              @Override
              public void mousePressed(MouseEvent event) {
                mark(number);
              }
            });
    rows.add(row);
    list.add(row.panel());
  }

  /** Returns what is above a part of the page: a grid's text, and the headings of its options. */
  private static JPanel above(
      QuestionnairePage part,
      boolean headed,
      QuestionRowLayout shape,
      ParticipantMessages wording,
      int width) {
    JPanel above = new JPanel();
    above.setOpaque(false);
    above.setAlignmentX(0);
    above.setLayout(new BoxLayout(above, BoxLayout.Y_AXIS));
    if (!part.stem().isEmpty()) {
      JComponent text = WrappedTextArea.of(part.stem(), 16f, width);
      text.setAlignmentX(0);
      JPanel padded = new JPanel(new BorderLayout());
      padded.setOpaque(false);
      padded.setAlignmentX(0);
      padded.setBorder(BorderFactory.createEmptyBorder(12, 12, 4, 12));
      padded.add(text, BorderLayout.WEST);
      above.add(padded);
    }
    JComponent heading = headed ? shape.heading(part, wording) : new JPanel();
    if (heading.getComponentCount() > 0) {
      heading.setAlignmentX(0);
      clear(heading);
      above.add(heading);
    }
    return above;
  }

  /** Lets the background of the rows be seen through a heading. */
  private static void clear(JComponent component) {
    component.setOpaque(false);
    for (Component each : component.getComponents()) {
      if (each instanceof JPanel panel) {
        clear(panel);
      }
    }
  }

  private static List<QuestionRow> both(List<QuestionRow> some, List<QuestionRow> more) {
    List<QuestionRow> all = new ArrayList<>(some);
    all.addAll(more);
    return all;
  }

  JScrollPane component() {
    return scroll;
  }

  /** Returns the height in pixels with all rows visible, to measure a page that is not shown. */
  int tallest() {
    rows.forEach(row -> row.panel().setVisible(true));
    return scroll.getPreferredSize().height;
  }

  /** Begins to record questions in view, as the page is on the screen now. */
  void begin() {
    SwingUtilities.invokeLater(
        () -> {
          look();
          if (!rows.isEmpty()) {
            mark(firstOpen(0));
          }
        });
  }

  /** Shows only the rows that are asked after the answers so far. */
  private void ask() {
    List<Question> asked = page.asked(course.answers());
    rows.forEach(row -> row.panel().setVisible(asked.contains(row.question())));
    headed.forEach(
        (above, own) -> above.setVisible(own.stream().anyMatch(row -> row.panel().isVisible())));
    scroll.revalidate();
    SwingUtilities.invokeLater(this::look);
  }

  /** Records the rows of which at least half is in view for the first time. */
  private void look() {
    if (!scroll.isShowing()) {
      return;
    }
    Rectangle view = scroll.getViewport().getViewRect();
    for (QuestionRow row : rows) {
      Rectangle place =
          SwingUtilities.convertRectangle(
              row.panel().getParent(), row.panel().getBounds(), scroll.getViewport().getView());
      Rectangle visible = view.intersection(place);
      boolean half = !visible.isEmpty() && 2 * visible.height >= place.height;
      if (row.panel().isVisible() && half) {
        course.saw(row.question());
      }
    }
  }

  @Override
  public void answered(QuestionRow row, Answer answer, boolean settled) {
    long now = System.nanoTime();
    // The response time of a text ends at its last key.
    long at = settled ? Optional.ofNullable(typed.remove(row)).orElse(now) : now;
    if (!settled) {
      typed.put(row, now);
    }
    course.answer(row.question(), answer, settled, at);
    ask();
    answered.run();
    if (settled && !row.takesText()) {
      int number = rows.indexOf(row);
      mark(row.answered() && row.settlesAtOnce() ? firstOpen(number) : number);
    }
  }

  @Override
  public void touched(QuestionRow row) {
    if (rows.indexOf(row) != current) {
      mark(rows.indexOf(row));
    }
  }

  /** Returns the next open row from a row on, cyclically; that row if all are answered. */
  private int firstOpen(int from) {
    for (int i = 0; i < rows.size(); i++) {
      int number = (from + i) % rows.size();
      if (rows.get(number).panel().isVisible() && !rows.get(number).answered()) {
        return number;
      }
    }
    return from;
  }

  private void mark(int number) {
    if (number != current && !rows.get(current).takesText()) {
      rows.get(current).settle(); // A digit that waits for a second one counts.
    }
    rows.get(current).current(false);
    current = number;
    QuestionRow row = rows.get(current);
    row.current(true);
    focus();
    row.panel()
        .scrollRectToVisible(new Rectangle(0, 0, row.panel().getWidth(), row.panel().getHeight()));
  }

  /** Focuses the current row's text field, or else the page. */
  void focus() {
    if (!rows.isEmpty() && rows.get(current).takesText()) {
      rows.get(current).focus();
    } else {
      scroll.requestFocusInWindow();
    }
  }

  /**
   * Handles a key that was pressed or typed in the window.
   *
   * @param writing whether a text field has the focus
   * @return whether the page has handled the key
   */
  boolean key(KeyEvent event, boolean writing) {
    if (rows.isEmpty()) {
      return false;
    }
    if (event.getID() == KeyEvent.KEY_TYPED) {
      return !writing
          && rows.get(current).panel().isVisible()
          && rows.get(current).key(event.getKeyChar());
    }
    if (!writing && rows.get(current).panel().isVisible() && rows.get(current).pressed(event)) {
      return true;
    }
    boolean lines = writing && !(event.getSource() instanceof javax.swing.JTextField);
    switch (event.getKeyCode()) {
      case KeyEvent.VK_DOWN -> {
        return !lines && step(1);
      }
      case KeyEvent.VK_UP -> {
        return !lines && step(-1);
      }
      case KeyEvent.VK_TAB -> {
        return step(event.isShiftDown() ? -1 : 1);
      }
      default -> {
        return false;
      }
    }
  }

  /** Makes the next row in a direction current; stays at the ends. */
  private boolean step(int by) {
    for (int number = current + by; number >= 0 && number < rows.size(); number += by) {
      if (rows.get(number).panel().isVisible()) {
        mark(number);
        return true;
      }
    }
    return true;
  }

  /** Returns whether a row waits for a second digit of a number. */
  boolean waits() {
    return rows.stream().anyMatch(QuestionRow::waits);
  }

  /** Reports text that was typed and is not reported yet. */
  void settle() {
    rows.forEach(QuestionRow::settle);
  }
}
