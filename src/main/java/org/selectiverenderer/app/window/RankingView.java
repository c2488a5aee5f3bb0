package org.selectiverenderer.app.window;

import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Cursor;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.List;
import javax.swing.BorderFactory;
import javax.swing.Box;
import javax.swing.BoxLayout;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import org.selectiverenderer.study.questionnaire.ChoiceOption;
import org.selectiverenderer.study.questionnaire.RankingField;
import org.selectiverenderer.swing.PlainText;

/**
 * Shows options to be put in order as a list: the mouse drags one to its place, up and down mark
 * one, with Shift they move it, a digit moves it to that place, and the space bar takes the order
 * as it is. An order is no answer before it was touched.
 */
final class RankingView implements FieldView {
  /** Milliseconds without a key after which an order is final. */
  private static final int REST = 800;

  private static final int WIDTH = 560;
  private static final Color MARKED = new Color(0x1f66b5);
  private static final Color OPEN = new Color(0x9a9a9a);

  private final RankingField field;
  private final Listener listener;
  private final JPanel panel = new JPanel();
  private final List<Item> items = new ArrayList<>();
  private final Timer rest = new Timer(REST, event -> settle());
  private Item marked;
  private boolean answered;
  private boolean open;

  /**
   * @param asked the question's text, for the accessible names of the options
   */
  RankingView(RankingField field, String id, String asked, Listener listener) {
    this.field = field;
    this.listener = listener;
    rest.setRepeats(false);
    panel.setOpaque(false);
    panel.setLayout(new BoxLayout(panel, BoxLayout.Y_AXIS));
    panel.setAlignmentX(0);
    for (ChoiceOption option : field.options()) {
      items.add(new Item(option, id, asked));
    }
    marked = items.get(0);
    lay();
    JComponent wide = (JComponent) Box.createRigidArea(new Dimension(WIDTH, 0));
    wide.setAlignmentX(0); // All options are equally wide.
    panel.add(wide);
  }

  /** An option with its place. */
  private final class Item {
    private final ChoiceOption option;
    private final JPanel line = new JPanel(new BorderLayout(12, 0));
    private final JLabel place = new HiDpiComponents.Label();

    Item(ChoiceOption option, String id, String asked) {
      this.option = option;
      JLabel text = new HiDpiComponents.Label();
      text.setText(QuestionRowLayout.wrapped(option.label(), WIDTH - 80, JLabel.LEFT));
      text.setFont(text.getFont().deriveFont(Font.PLAIN, 15f));
      place.setFont(place.getFont().deriveFont(Font.BOLD, 15f));
      place.setHorizontalAlignment(JLabel.RIGHT);
      place.setPreferredSize(new Dimension(28, 20));
      line.add(place, BorderLayout.WEST);
      line.add(text, BorderLayout.CENTER);
      line.setAlignmentX(0);
      line.setName(id + ":" + option.value());
      line.getAccessibleContext().setAccessibleName(asked + ": " + option.label());
      line.setCursor(Cursor.getPredefinedCursor(Cursor.MOVE_CURSOR));
      line.setMaximumSize(new Dimension(WIDTH, Integer.MAX_VALUE));
      MouseAdapter mouse =
          new MouseAdapter() {
            @Override
            public void mousePressed(MouseEvent event) {
              if (SwingUtilities.isLeftMouseButton(event)) {
                marked = Item.this;
                fill();
              }
            }

            @Override
            public void mouseDragged(MouseEvent event) {
              if (SwingUtilities.isLeftMouseButton(event)) {
                int y = SwingUtilities.convertPoint(line, event.getPoint(), panel).y;
                move(placeAt(y));
              }
            }

            @Override
            public void mouseReleased(MouseEvent event) {
              settle();
            }
          };
      line.addMouseListener(mouse);
      line.addMouseMotionListener(mouse);
    }

    void show(int number) {
      place.setText(PlainText.of(number + "."));
      place.setForeground(answered ? MARKED : OPEN);
      line.setBackground(Color.WHITE);
      Color edge = this == marked ? MARKED : new Color(0xc8c8c8);
      line.setBorder(
          BorderFactory.createCompoundBorder(
              BorderFactory.createEmptyBorder(2, 0, 2, 0),
              BorderFactory.createCompoundBorder(
                  BorderFactory.createLineBorder(edge, this == marked ? 2 : 1),
                  BorderFactory.createEmptyBorder(
                      this == marked ? 4 : 5, 6, this == marked ? 4 : 5, 6))));
    }
  }

  /** Returns the place in the list at a height of the panel. */
  private int placeAt(int y) {
    int place = 0;
    while (place < items.size() - 1
        && y > items.get(place).line.getY() + items.get(place).line.getHeight()) {
      place++;
    }
    return place;
  }

  /** Lays the items out in their order; components are only moved, so that a drag goes on. */
  private void lay() {
    for (int place = 0; place < items.size(); place++) {
      JPanel line = items.get(place).line;
      if (line.getParent() == null) {
        panel.add(line);
      } else {
        panel.setComponentZOrder(line, place);
      }
      items.get(place).show(place + 1);
    }
    panel.revalidate();
    panel.repaint();
  }

  private void move(int to) {
    int place = Math.max(0, Math.min(items.size() - 1, to));
    if (items.indexOf(marked) != place) {
      items.remove(marked);
      items.add(place, marked);
    }
    fill();
  }

  /** Takes the order as an answer that may still change. */
  private void fill() {
    answered = true;
    open = true;
    lay();
    listener.filled(value(), false);
  }

  private String value() {
    return RankingField.value(items.stream().map(item -> item.option).toList());
  }

  @Override
  public JComponent component() {
    return panel;
  }

  @Override
  public void show(String value) {
    answered = !value.isEmpty();
    List<ChoiceOption> order = field.ordered(value);
    items.sort((one, other) -> order.indexOf(one.option) - order.indexOf(other.option));
    lay();
  }

  @Override
  public boolean pressed(KeyEvent key) {
    int by =
        switch (key.getKeyCode()) {
          case KeyEvent.VK_UP -> -1;
          case KeyEvent.VK_DOWN -> 1;
          default -> 0;
        };
    int place = items.indexOf(marked);
    if (by == 0) {
      return false;
    }
    if (key.isShiftDown() || key.isControlDown() || key.isAltDown()) {
      move(place + by);
      rest.restart();
      return true;
    }
    if (place + by < 0 || place + by >= items.size()) {
      return false; // Goes on to the next question.
    }
    marked = items.get(place + by);
    lay();
    return true;
  }

  @Override
  public boolean key(char key) {
    int place = Character.digit(key, 10) - 1;
    if (key == ' ') {
      fill();
      settle();
      return true;
    }
    if (place < 0 || place >= items.size()) {
      return false;
    }
    move(place);
    rest.restart();
    return true;
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
    if (open) {
      open = false;
      listener.filled(value(), true);
    }
  }
}
