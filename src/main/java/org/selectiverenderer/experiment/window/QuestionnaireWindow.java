package org.selectiverenderer.experiment.window;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.GridBagLayout;
import java.awt.KeyEventDispatcher;
import java.awt.KeyboardFocusManager;
import java.awt.Rectangle;
import java.awt.Toolkit;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.BoxLayout;
import javax.swing.JButton;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import javax.swing.WindowConstants;
import org.selectiverenderer.experiment.questionnaire.Answer;
import org.selectiverenderer.experiment.questionnaire.PaperPage;
import org.selectiverenderer.experiment.questionnaire.QuestionItem;
import org.selectiverenderer.experiment.questionnaire.Screen;
import org.selectiverenderer.experiment.questionnaire.Wording;

/**
 * A screen of questions about one area. Keys answer the row that is marked; when it is complete,
 * the next one that is not is marked. The window ends when all is answered and the participant goes
 * on, or with the session; closing it has the experimenter asked.
 */
public final class QuestionnaireWindow {
  private final Screen screen;
  private final Wording wording;
  private final Consumer<Boolean> done;
  private final List<QuestionRow> rows = new ArrayList<>();
  private final JFrame frame = new JFrame();
  private final JLabel left = new JLabel();
  private final JButton next = new JButton();
  private final KeyEventDispatcher keys = this::key;
  private int current;

  private QuestionnaireWindow(
      Screen screen,
      Wording wording,
      Map<String, Answer> known,
      BiConsumer<QuestionItem, Answer> taker,
      SessionEnd sessionEnd,
      Consumer<Boolean> done) {
    this.screen = screen;
    this.wording = wording;
    this.done = done;
    JPanel list = new JPanel();
    list.setLayout(new BoxLayout(list, BoxLayout.Y_AXIS));
    for (QuestionItem item : screen.items()) {
      int number = rows.size();
      QuestionRow row =
          new QuestionRow(
              screen.kind(),
              item,
              known.getOrDefault(item.object(), Answer.NONE),
              wording,
              (asked, answer) -> {
                taker.accept(asked, answer);
                answered(number);
              });
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
    lay(list);
    sessionEnd.watch(frame, () -> end(false));
    KeyboardFocusManager.getCurrentKeyboardFocusManager().addKeyEventDispatcher(keys);
    mark(firstOpen(0));
    count();
  }

  /**
   * Asks, and waits until all is answered or the session ends.
   *
   * @param known answers given before, by object
   * @param taker hears every answer and every change of one, on Swing's thread
   * @return whether all was answered and the participant went on
   */
  public static boolean ask(
      Screen screen,
      Wording wording,
      Map<String, Answer> known,
      BiConsumer<QuestionItem, Answer> taker,
      SessionEnd sessionEnd) {
    AtomicBoolean through = new AtomicBoolean();
    Waiting.on(
        done ->
            new QuestionnaireWindow(
                    screen,
                    wording,
                    known,
                    taker,
                    sessionEnd,
                    complete -> {
                      through.set(complete);
                      done.run();
                    })
                .frame);
    return through.get();
  }

  private void lay(JPanel list) {
    String kind = screen.kind().spelling();
    String area = wording.area(screen.area());
    JLabel title = new JLabel(PaperPage.fill(wording.of(kind + ".title"), area));
    title.setFont(title.getFont().deriveFont(24f));
    JTextArea text = text(PaperPage.fill(wording.of(kind + ".text"), area));
    text.setFont(title.getFont().deriveFont(15f));
    JPanel head = new JPanel(new BorderLayout(0, 8));
    head.setBorder(BorderFactory.createEmptyBorder(16, 16, 12, 16));
    head.add(title, BorderLayout.NORTH);
    head.add(text, BorderLayout.CENTER);
    JPanel top = new JPanel(new BorderLayout());
    top.setBackground(QuestionRow.PLAIN);
    top.add(list, BorderLayout.NORTH); // However few rows, they stand close.
    JScrollPane scroll = new JScrollPane(top);
    scroll.setColumnHeaderView(QuestionRow.heading(screen.kind(), wording));
    scroll.getVerticalScrollBar().setUnitIncrement(24);
    next.setText(wording.of("next"));
    next.setName("next");
    next.setFocusable(false);
    next.addActionListener(event -> goOn());
    JPanel foot = new JPanel(new BorderLayout(16, 0));
    foot.setBorder(BorderFactory.createEmptyBorder(12, 16, 16, 16));
    JTextArea hint = text(PaperPage.fill(wording.of("keys"), wording.of("keys." + kind)));
    hint.setFont(left.getFont());
    hint.setRows(2);
    JPanel told = new JPanel(new BorderLayout());
    told.add(left, BorderLayout.NORTH);
    told.add(hint, BorderLayout.CENTER);
    foot.add(told, BorderLayout.CENTER);
    JPanel button = new JPanel(new GridBagLayout());
    button.add(next);
    foot.add(button, BorderLayout.EAST);
    frame.setTitle(title.getText());
    frame.setName("questionnaire");
    frame.setDefaultCloseOperation(WindowConstants.DO_NOTHING_ON_CLOSE);
    frame.add(head, BorderLayout.NORTH);
    frame.add(scroll, BorderLayout.CENTER);
    frame.add(foot, BorderLayout.SOUTH);
    Dimension most = Toolkit.getDefaultToolkit().getScreenSize();
    frame.setSize(Math.min(960, most.width), Math.min(1000, most.height));
    frame.setLocationRelativeTo(null);
  }

  /** Words that go on in the next line where the window is too narrow for them. */
  private static JTextArea text(String words) {
    JTextArea text = new JTextArea(words);
    text.setEditable(false);
    text.setFocusable(false);
    text.setLineWrap(true);
    text.setWrapStyleWord(true);
    text.setOpaque(false);
    text.setBorder(BorderFactory.createEmptyBorder());
    return text;
  }

  private boolean key(KeyEvent event) {
    if (KeyboardFocusManager.getCurrentKeyboardFocusManager().getActiveWindow() != frame) {
      return false;
    }
    if (event.getID() == KeyEvent.KEY_TYPED) {
      return rows.get(current).key(event.getKeyChar());
    }
    if (event.getID() != KeyEvent.KEY_PRESSED) {
      return false;
    }
    switch (event.getKeyCode()) {
      case KeyEvent.VK_DOWN -> mark(Math.min(rows.size() - 1, current + 1));
      case KeyEvent.VK_UP -> mark(Math.max(0, current - 1));
      case KeyEvent.VK_ENTER -> goOn();
      default -> {
        return false;
      }
    }
    return true;
  }

  private void answered(int number) {
    mark(rows.get(number).complete() ? firstOpen(number) : number);
    count();
  }

  /** The first row from one on that is not complete, going round; that one if all are. */
  private int firstOpen(int from) {
    for (int i = 0; i < rows.size(); i++) {
      int number = (from + i) % rows.size();
      if (!rows.get(number).complete()) {
        return number;
      }
    }
    return from;
  }

  private void mark(int number) {
    rows.get(current).current(false);
    current = number;
    QuestionRow row = rows.get(current);
    row.current(true);
    row.panel()
        .scrollRectToVisible(new Rectangle(0, 0, row.panel().getWidth(), row.panel().getHeight()));
  }

  private void count() {
    long open = rows.stream().filter(row -> !row.complete()).count();
    left.setText(PaperPage.fill(wording.of("left"), open, rows.size()));
    left.setVisible(open > 0);
    next.setEnabled(open == 0);
  }

  private void goOn() {
    if (next.isEnabled()) {
      end(true);
    }
  }

  private void end(boolean complete) {
    KeyboardFocusManager.getCurrentKeyboardFocusManager().removeKeyEventDispatcher(keys);
    next.setEnabled(false);
    done.accept(complete);
  }
}
