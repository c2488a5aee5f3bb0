package org.selectiverenderer.enricher.versions;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.util.Arrays;
import javax.accessibility.Accessible;
import javax.accessibility.AccessibleContext;
import javax.accessibility.AccessibleRole;
import javax.swing.AbstractAction;
import javax.swing.JComponent;
import javax.swing.KeyStroke;
import javax.swing.UIManager;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.enricher.text.Texts;

/**
 * The view of a version's mesh, solid or as a wireframe. Dragging, the arrow keys, + and - turn and
 * zoom all views of one {@link TurntableCamera}.
 */
@SuppressWarnings("serial") // never written
final class MeshView extends JComponent implements Accessible {
  private static final long serialVersionUID = 1L;
  private static final double STEP = Math.toRadians(10);

  private final TurntableCamera turntable;
  private final boolean wires;
  private @Nullable ColoredMesh shape;
  private BoundingSphere frame = new BoundingSphere(0, 0, 0, 1);

  MeshView(TurntableCamera turntable, boolean wires) {
    this.turntable = turntable;
    this.wires = wires;
    turntable.addListener(this::repaint);
    setFocusable(true);
    Turning turning = new Turning();
    addMouseListener(turning);
    addMouseMotionListener(turning);
    addMouseWheelListener(turning);
    addFocusListener(
        new FocusAdapter() {
          @Override
          public void focusGained(FocusEvent event) {
            repaint();
          }

          @Override
          public void focusLost(FocusEvent event) {
            repaint();
          }
        });
    key("LEFT", () -> turntable.turn(-STEP, 0));
    key("RIGHT", () -> turntable.turn(STEP, 0));
    key("UP", () -> turntable.turn(0, STEP));
    key("DOWN", () -> turntable.turn(0, -STEP));
    key("typed +", () -> turntable.zoom(1.2));
    key("typed -", () -> turntable.zoom(1 / 1.2));
    setToolTipText(Texts.of("versions.turn"));
  }

  private void key(String key, Runnable work) {
    getInputMap().put(KeyStroke.getKeyStroke(key), key);
    getActionMap()
        .put(
            key,
            new AbstractAction() {
              private static final long serialVersionUID = 1L;

              @Override
              public void actionPerformed(java.awt.event.ActionEvent event) {
                work.run();
              }
            });
  }

  /** Shows a version's mesh, or nothing, at the scale of the original. */
  void show(@Nullable ColoredMesh version, BoundingSphere original) {
    shape = version;
    frame = original;
    repaint();
  }

  @Override
  public Dimension getPreferredSize() {
    int letter = getFontMetrics(UIManager.getFont("Label.font")).getHeight();
    return new Dimension(17 * letter, 13 * letter);
  }

  @Override
  protected void paintComponent(Graphics graphics) {
    Graphics2D g = (Graphics2D) graphics.create();
    // Draw in device pixels, of which a HiDPI screen has several per unit of Swing.
    double scale = g.getTransform().getScaleX();
    int width = Math.max(1, (int) Math.round(getWidth() * scale));
    int height = Math.max(1, (int) Math.round(getHeight() * scale));
    BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
    int[] pixels = ((DataBufferInt) image.getRaster().getDataBuffer()).getData();
    Arrays.fill(pixels, color("TextField.background").getRGB());
    if (shape != null) {
      SoftwareRasterizer painter = new SoftwareRasterizer(pixels, width, height);
      if (wires) {
        painter.wires(shape, frame, turntable, color("Label.foreground").getRGB());
      } else {
        painter.solid(shape, frame, turntable);
      }
    }
    g.drawImage(image, 0, 0, getWidth(), getHeight(), null);
    g.setColor(color(isFocusOwner() ? "Component.focusColor" : "Component.borderColor"));
    g.drawRect(0, 0, getWidth() - 1, getHeight() - 1);
    g.dispose();
  }

  private Color color(String key) {
    Color color = UIManager.getColor(key);
    return color == null ? (key.endsWith("background") ? getBackground() : getForeground()) : color;
  }

  @Override
  public AccessibleContext getAccessibleContext() {
    if (accessibleContext == null) {
      accessibleContext =
          new AccessibleJComponent() {
            private static final long serialVersionUID = 1L;

            @Override
            public AccessibleRole getAccessibleRole() {
              return AccessibleRole.CANVAS;
            }
          };
    }
    return accessibleContext;
  }

  private final class Turning extends MouseAdapter {
    private Point last = new Point();

    @Override
    public void mousePressed(MouseEvent event) {
      last = event.getPoint();
      requestFocusInWindow();
    }

    @Override
    public void mouseDragged(MouseEvent event) {
      double perPixel = Math.PI / Math.max(1, getWidth());
      turntable.turn((last.x - event.getX()) * perPixel, (event.getY() - last.y) * perPixel);
      last = event.getPoint();
    }

    @Override
    public void mouseWheelMoved(MouseWheelEvent event) {
      turntable.zoom(Math.pow(1.15, -event.getPreciseWheelRotation()));
    }
  }
}
