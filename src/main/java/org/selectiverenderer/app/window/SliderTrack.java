package org.selectiverenderer.app.window;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.geom.Line2D;
import java.awt.geom.RoundRectangle2D;
import java.util.OptionalInt;
import javax.accessibility.AccessibleContext;
import javax.accessibility.AccessibleRole;
import javax.accessibility.AccessibleValue;
import javax.swing.JComponent;
import javax.swing.SwingUtilities;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.study.questionnaire.SliderField;

/** The line of a slider with its marks and its thumb, which the mouse puts and drags. */
final class SliderTrack extends JComponent {
  private static final long serialVersionUID = 1L;

  /** Room at both ends for half of the thumb and half of a number. */
  private static final int END = 16;

  private static final int LABELS = 18;
  private static final int HEIGHT = 34;
  private static final int THUMB_WIDTH = 12;
  private static final int THUMB_HEIGHT = 24;
  private static final Color LINE = new Color(0x6f6f6f);
  private static final Color CHOSEN = new Color(0x1f66b5);

  /** Receives positions. */
  interface Listener {
    /**
     * The thumb was moved.
     *
     * @param dropped whether the mouse was released, so that the position is final
     */
    void moved(int position, boolean dropped);
  }

  private final transient SliderField field;
  private OptionalInt thumb = OptionalInt.empty();
  private boolean answered;

  SliderTrack(SliderField field, int width, Listener listener) {
    this.field = field;
    Dimension size = new Dimension(width, HEIGHT + (field.labelled().isEmpty() ? 0 : LABELS));
    setPreferredSize(size);
    setMinimumSize(size);
    setMaximumSize(size);
    MouseAdapter mouse =
        new MouseAdapter() {
          @Override
          public void mousePressed(MouseEvent event) {
            tell(event, false);
          }

          @Override
          public void mouseDragged(MouseEvent event) {
            tell(event, false);
          }

          @Override
          public void mouseReleased(MouseEvent event) {
            tell(event, true);
          }

          private void tell(MouseEvent event, boolean dropped) {
            if (SwingUtilities.isLeftMouseButton(event)) {
              listener.moved(position(event.getX()), dropped);
            }
          }
        };
    addMouseListener(mouse);
    addMouseMotionListener(mouse);
  }

  /**
   * Shows the thumb.
   *
   * @param position empty for no thumb
   * @param touched whether the position is an answer; else the thumb is drawn hollow
   */
  void show(OptionalInt position, boolean touched) {
    thumb = position;
    answered = touched;
    repaint();
  }

  /** Returns the x coordinate of a position. */
  int x(int position) {
    return END + (int) Math.round((getWidth() - 2.0 * END) * position / field.last());
  }

  private int position(int x) {
    double at = (x - END) * (double) field.last() / Math.max(1, getWidth() - 2 * END);
    return (int) Math.max(0, Math.min(field.last(), Math.round(at)));
  }

  @Override
  protected void paintComponent(Graphics graphics) {
    Graphics2D drawing = (Graphics2D) graphics.create();
    drawing.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    drawing.setRenderingHint(
        RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
    double middle = HEIGHT / 2.0;
    drawing.setColor(LINE);
    drawing.setStroke(new BasicStroke(2, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
    drawing.draw(new Line2D.Double(x(0), middle, x(field.last()), middle));
    drawing.setStroke(new BasicStroke(1.2f));
    for (int mark : field.marked()) {
      drawing.draw(new Line2D.Double(x(mark), middle - 7, x(mark), middle + 7));
    }
    drawing.setFont(getFont().deriveFont(12f));
    for (int label : field.labelled()) {
      String text = field.value(label);
      int width = drawing.getFontMetrics().stringWidth(text);
      int left = Math.max(0, Math.min(getWidth() - width, x(label) - width / 2));
      drawing.drawString(text, left, HEIGHT + 10);
    }
    if (thumb.isPresent()) {
      RoundRectangle2D shape =
          new RoundRectangle2D.Double(
              x(thumb.getAsInt()) - THUMB_WIDTH / 2.0,
              middle - THUMB_HEIGHT / 2.0,
              THUMB_WIDTH,
              THUMB_HEIGHT,
              8,
              8);
      drawing.setColor(answered ? CHOSEN : Color.WHITE);
      drawing.fill(shape);
      drawing.setColor(CHOSEN);
      drawing.setStroke(new BasicStroke(1.6f));
      drawing.draw(shape);
    }
    drawing.dispose();
  }

  @Override
  public AccessibleContext getAccessibleContext() {
    if (accessibleContext == null) {
      accessibleContext = new Spoken();
    }
    return accessibleContext;
  }

  /** Tells a screen reader that this is a slider, and its value. */
  private final class Spoken extends AccessibleJComponent implements AccessibleValue {
    private static final long serialVersionUID = 1L;

    @Override
    public AccessibleRole getAccessibleRole() {
      return AccessibleRole.SLIDER;
    }

    @Override
    public AccessibleValue getAccessibleValue() {
      return this;
    }

    @Override
    public @Nullable Number getCurrentAccessibleValue() {
      return thumb.isPresent() && answered
          ? new java.math.BigDecimal(field.value(thumb.getAsInt()))
          : null;
    }

    @Override
    public boolean setCurrentAccessibleValue(Number number) {
      return false;
    }

    @Override
    public Number getMinimumAccessibleValue() {
      return field.from();
    }

    @Override
    public Number getMaximumAccessibleValue() {
      return field.to();
    }
  }
}
