package org.selectiverenderer.app.window;

import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Component;
import java.awt.Cursor;
import java.awt.EventQueue;
import java.awt.FlowLayout;
import java.awt.Font;
import java.awt.Graphics;
import java.awt.GraphicsEnvironment;
import java.awt.GridBagLayout;
import java.awt.KeyEventDispatcher;
import java.awt.KeyboardFocusManager;
import java.awt.Rectangle;
import java.awt.event.ActionEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.Optional;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import javax.swing.BorderFactory;
import javax.swing.BoxLayout;
import javax.swing.ImageIcon;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JOptionPane;
import javax.swing.JPanel;
import javax.swing.JTextArea;
import javax.swing.SwingConstants;
import javax.swing.Timer;
import javax.swing.WindowConstants;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.study.questionnaire.ParticipantMessages;
import org.selectiverenderer.swing.PlainText;

/**
 * Shows the trials of a threshold pilot one after the other, each after a short blank interval, so
 * that the participant does not see one picture change into another. One thread opens the window
 * and waits for answers; events are handled on Swing's thread. Closing the window asks whether to
 * end the pilot.
 */
public final class TrialWindow implements AutoCloseable {
  /** The background colour of the pictures. */
  private static final Color GREY = new Color(209, 209, 209);

  private static final int EMPTY_MS = 400;
  private static final int GAP = 24;
  private static final int MARGIN = 260;

  private final ParticipantMessages wording;
  private final JFrame frame = new JFrame();
  private final LinkedBlockingQueue<Optional<Reply>> replies = new LinkedBlockingQueue<>();
  private final KeyEventDispatcher keys = this::key;
  private @Nullable TrialPage page;
  private long shownAt;

  /**
   * An answer.
   *
   * @param choice from 0, or {@link TrialPage#NONE}
   * @param ms response time in milliseconds from when the pictures were painted
   */
  public record Reply(int choice, long ms) {}

  private TrialWindow(ParticipantMessages wording, String title) {
    this.wording = wording;
    frame.setTitle(title);
    frame.setName("trial");
    frame.getContentPane().setBackground(GREY);
    frame.setDefaultCloseOperation(WindowConstants.DO_NOTHING_ON_CLOSE);
    frame.addWindowListener(new CloseInterceptor(this::askEnd));
    frame.setBounds(screen());
    KeyboardFocusManager.getCurrentKeyboardFocusManager().addKeyEventDispatcher(keys);
  }

  private static Rectangle screen() {
    return GraphicsEnvironment.getLocalGraphicsEnvironment().getMaximumWindowBounds();
  }

  /**
   * Returns the greatest width, in pixels, of a number of pictures that fit on the screen side by
   * side.
   */
  public static int mostPixels(int pictures) {
    Rectangle screen = screen();
    return Math.min((screen.width - (pictures + 1) * GAP) / pictures, screen.height - MARGIN);
  }

  /** Opens the window. */
  public static TrialWindow open(ParticipantMessages wording, String title) {
    TrialWindow window = ModalWindowRunner.onSwing(() -> new TrialWindow(wording, title));
    EventQueue.invokeLater(() -> window.frame.setVisible(true));
    return window;
  }

  /**
   * Shows the instructions, and waits until the participant begins.
   *
   * @return false if the pilot is to end
   */
  public boolean introduce(String heading, String text) throws InterruptedException {
    EventQueue.invokeLater(() -> show(introduction(heading, text)));
    return replies.take().isPresent();
  }

  private JComponent introduction(String heading, String text) {
    page = null;
    JTextArea words = new JTextArea(text, 0, 46);
    words.setLineWrap(true);
    words.setWrapStyleWord(true);
    words.setEditable(false);
    words.setFocusable(false);
    words.setOpaque(false);
    words.setBorder(BorderFactory.createEmptyBorder());
    words.setFont(label(heading, 18f).getFont());
    words.setAlignmentX(Component.LEFT_ALIGNMENT);
    JButton begin = new JButton(PlainText.of(wording.of("form.begin")));
    begin.setName("begin");
    begin.setFont(begin.getFont().deriveFont(18f));
    begin.setAlignmentX(Component.LEFT_ALIGNMENT);
    begin.addActionListener(
        event -> {
          begin.setEnabled(false);
          replies.add(Optional.of(new Reply(0, 0)));
        });
    frame.getRootPane().setDefaultButton(begin);
    JPanel column = column();
    JLabel title = label(heading, 30f);
    title.setAlignmentX(Component.LEFT_ALIGNMENT);
    column.add(title);
    column.add(gap());
    column.add(words);
    column.add(gap());
    column.add(begin);
    return middle(column);
  }

  /**
   * Shows a trial and waits for the answer.
   *
   * @return empty if the pilot is to end
   */
  public Optional<Reply> ask(TrialPage trial) throws InterruptedException {
    EventQueue.invokeLater(
        () -> {
          page = null;
          show(new JPanel(new BorderLayout()));
          Timer timer = new Timer(EMPTY_MS, event -> show(trial));
          timer.setRepeats(false);
          timer.start();
        });
    return replies.take();
  }

  private void show(TrialPage trial) {
    shownAt = 0;
    page = trial;
    JPanel row = new JPanel(new FlowLayout(FlowLayout.CENTER, GAP, 0));
    row.setOpaque(false);
    int last = trial.pictures().size() - 1;
    for (int i = 0; i <= last; i++) {
      boolean middle = last > 0 && i > 0 && i < last;
      JLabel picture = picture(trial, i);
      picture.setText(middle ? PlainText.of(trial.caption()) : " ");
      if (trial.choices().isEmpty() && !middle) {
        clickable(picture, i == 0 ? 0 : 1);
      }
      row.add(picture);
    }
    JPanel column = column();
    column.add(centred(label(trial.question(), 24f)));
    column.add(gap());
    column.add(row);
    if (!trial.choices().isEmpty()) {
      column.add(gap());
      column.add(buttons(trial));
    }
    column.add(gap());
    column.add(centred(label(trial.keys(), 15f)));
    column.add(centred(label(trial.progress(), 13f)));
    show(middle(column));
    frame.getContentPane().requestFocusInWindow();
  }

  /**
   * Returns a label with a picture; the response time starts when it is painted, not when it is
   * made.
   */
  private JLabel picture(TrialPage trial, int number) {
    JLabel label =
        new JLabel(new ImageIcon(trial.pictures().get(number))) {
          private static final long serialVersionUID = 1L;

          @Override
          protected void paintComponent(Graphics graphics) {
            super.paintComponent(graphics);
            if (shownAt == 0) {
              shownAt = System.nanoTime();
            }
          }
        };
    label.setName("picture-" + (number + 1));
    label.setHorizontalTextPosition(SwingConstants.CENTER);
    label.setVerticalTextPosition(SwingConstants.BOTTOM);
    label.setIconTextGap(8);
    label.setFont(label.getFont().deriveFont(16f));
    return label;
  }

  private void clickable(JLabel picture, int choice) {
    picture.setCursor(Cursor.getPredefinedCursor(Cursor.HAND_CURSOR));
    picture.addMouseListener(
        new MouseAdapter() {
          @Override
          public void mousePressed(MouseEvent event) {
            answer(choice);
          }
        });
  }

  private JPanel buttons(TrialPage trial) {
    JPanel row = new JPanel(new FlowLayout(FlowLayout.CENTER, GAP / 2, 0));
    row.setOpaque(false);
    for (int i = 0; i < trial.choices().size(); i++) {
      row.add(button((i + 1) + "  " + trial.choices().get(i), i));
    }
    if (!trial.none().isEmpty()) {
      row.add(button("0  " + trial.none(), TrialPage.NONE));
    }
    return row;
  }

  private JButton button(String text, int choice) {
    JButton button = new JButton(PlainText.of(text));
    button.setName("choice-" + (choice + 1));
    button.setFont(button.getFont().deriveFont(18f));
    button.setFocusable(false);
    button.addActionListener((ActionEvent event) -> answer(choice));
    return button;
  }

  private boolean key(KeyEvent event) {
    TrialPage shown = page;
    if (shown == null
        || event.getID() != KeyEvent.KEY_PRESSED
        || KeyboardFocusManager.getCurrentKeyboardFocusManager().getActiveWindow() != frame) {
      return false;
    }
    int code = event.getKeyCode();
    if (shown.choices().isEmpty()) {
      if (code == KeyEvent.VK_LEFT || code == KeyEvent.VK_RIGHT) {
        answer(code == KeyEvent.VK_LEFT ? 0 : 1);
        return true;
      }
      return false;
    }
    int number = Character.digit(event.getKeyChar(), 10);
    if (number == 0 && !shown.none().isEmpty()) {
      answer(TrialPage.NONE);
    } else if (number >= 1 && number <= shown.choices().size()) {
      answer(number - 1);
    } else {
      return false;
    }
    return true;
  }

  /** Records an answer; ignores one given before the pictures are painted. */
  private void answer(int choice) {
    if (page != null && shownAt != 0) {
      page = null;
      long ms = TimeUnit.NANOSECONDS.toMillis(System.nanoTime() - shownAt);
      replies.add(Optional.of(new Reply(choice, ms)));
    }
  }

  private void askEnd() {
    if (JOptionPane.showConfirmDialog(
            frame,
            PlainText.of(wording.of("threshold.end")),
            frame.getTitle(),
            JOptionPane.YES_NO_OPTION)
        == JOptionPane.YES_OPTION) {
      replies.add(Optional.empty());
    }
  }

  private void show(JComponent content) {
    content.setBackground(GREY);
    frame.getContentPane().removeAll();
    frame.getContentPane().add(content, BorderLayout.CENTER);
    frame.revalidate();
    frame.repaint();
  }

  private static JPanel middle(JComponent content) {
    JPanel panel = new JPanel(new GridBagLayout());
    panel.add(content);
    return panel;
  }

  private static JPanel column() {
    JPanel column = new JPanel();
    column.setLayout(new BoxLayout(column, BoxLayout.Y_AXIS));
    column.setOpaque(false);
    return column;
  }

  private static JComponent gap() {
    JPanel gap = new JPanel();
    gap.setOpaque(false);
    gap.setBorder(BorderFactory.createEmptyBorder(GAP / 2, 0, 0, 0));
    gap.setAlignmentX(Component.LEFT_ALIGNMENT);
    return gap;
  }

  private static JPanel centred(JLabel label) {
    JPanel row = new JPanel(new FlowLayout(FlowLayout.CENTER, 0, 2));
    row.setOpaque(false);
    row.add(label);
    return row;
  }

  private static JLabel label(String text, float size) {
    JLabel label = new JLabel(PlainText.of(text));
    label.setFont(label.getFont().deriveFont(Font.PLAIN, size));
    return label;
  }

  @Override
  public void close() {
    KeyboardFocusManager.getCurrentKeyboardFocusManager().removeKeyEventDispatcher(keys);
    EventQueue.invokeLater(frame::dispose);
  }
}
