package org.selectiverenderer.enricher.preview;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.event.KeyAdapter;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Rectangle2D;
import java.util.Optional;
import java.util.function.Supplier;
import javax.swing.SwingUtilities;
import org.joml.Vector2d;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.authoring.area.AreaBox;
import org.selectiverenderer.authoring.area.AreaInstance;
import org.selectiverenderer.authoring.area.SnapGrid;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.enricher.area.NodeCommands;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Texts;

/**
 * The handles of the selected area's box in the picture: six on its faces, one at its centre.
 * Dragging one shows the changed box in the running scene only; releasing the mouse makes one edit.
 * Escape cancels the drag; Alt turns the grid off. It receives mouse events before {@link
 * PreviewInputController} and consumes those that it uses.
 */
final class AreaHandles extends MouseAdapter {
  private static final double RADIUS = 6;
  private static final double REACH = 10;
  private static final Color FILL = new Color(0xff8c00);
  private static final Color HOT = new Color(0xffd000);
  private static final Color PAPER = new Color(0, 0, 0, 170);

  private final PreviewCanvas view;
  private final EnricherSession session;
  private final NodeCommands nodes;
  private final Supplier<SnapGrid> grid;
  private final LiveBox live;
  private boolean shown = true;
  private int hot = -1;
  private @Nullable AreaHandleDrag drag;
  private AreaBox dragged;

  /** Whether the drag was cancelled while the mouse button is still down. */
  private boolean takenBack;

  /** Shows a changed box in the running scene. */
  @FunctionalInterface
  interface LiveBox {
    void show(AreaInstance area, AreaBox box);
  }

  AreaHandles(PreviewCanvas view, EnricherSession session, Supplier<SnapGrid> grid, LiveBox live) {
    this.view = view;
    this.session = session;
    this.nodes = new NodeCommands(session);
    this.grid = grid;
    this.live = live;
    dragged = new AreaBox(new Vector3d(), new Vector3d());
    view.addMouseListener(this);
    view.addMouseMotionListener(this);
    view.addKeyListener(
        new KeyAdapter() {
          @Override
          public void keyPressed(KeyEvent event) {
            if (event.getKeyCode() == KeyEvent.VK_ESCAPE && drag != null) {
              cancel();
              event.consume();
            }
          }
        });
    view.overlay(this::paint);
  }

  /** Shows or hides the handles. */
  void shown(boolean show) {
    shown = show;
    view.repaint();
  }

  private Optional<AreaInstance> area() {
    boolean looking =
        view.frame().filter(frame -> !frame.walking()).isPresent()
            && session.document().locked().isEmpty();
    return shown && looking ? session.selection().flatMap(nodes::area) : Optional.empty();
  }

  /** Returns the nearest handle at a position of the view; -1 for none. */
  private int at(AreaInstance area, PreviewFrame frame, double x, double y) {
    double scale = view.scale();
    int found = -1;
    double nearest = REACH;
    for (int handle = 0; handle < AreaHandleDrag.HANDLES; handle++) {
      Optional<Vector2d> place =
          AreaHandleDrag.inPicture(AreaHandleDrag.place(area, handle), frame.camera());
      double distance =
          place.map(at -> at.distance(x * scale, y * scale) / scale).orElse(nearest + 1);
      if (distance < nearest) {
        nearest = distance;
        found = handle;
      }
    }
    return found;
  }

  @Override
  public void mouseMoved(MouseEvent event) {
    int before = hot;
    hot = handle(event);
    if (hot != before) {
      view.repaint();
    }
  }

  private int handle(MouseEvent event) {
    Optional<AreaInstance> area = area();
    return area.isPresent() && x(event) >= 0
        ? at(area.get(), view.frame().orElseThrow(), x(event), event.getY())
        : -1;
  }

  /** The mouse position in the picture that has the handles, right of a reference image. */
  private double x(MouseEvent event) {
    return event.getX() - view.left();
  }

  @Override
  public void mousePressed(MouseEvent event) {
    takenBack = false;
    hot = handle(event);
    if (hot >= 0 && SwingUtilities.isLeftMouseButton(event)) {
      view.requestFocusInWindow();
      AreaInstance area = area().orElseThrow();
      double scale = view.scale();
      drag =
          new AreaHandleDrag(
              area,
              hot,
              view.frame().orElseThrow().camera(),
              x(event) * scale,
              event.getY() * scale);
      dragged = area.box();
      event.consume();
    }
  }

  @Override
  public void mouseDragged(MouseEvent event) {
    if (takenBack) {
      event.consume();
    } else if (drag != null) {
      double scale = view.scale();
      SnapGrid step = event.isAltDown() ? SnapGrid.NONE : grid.get();
      dragged = drag.at(x(event) * scale, event.getY() * scale, step);
      live.show(drag.area(), dragged);
      event.consume();
      view.repaint();
    }
  }

  @Override
  public void mouseReleased(MouseEvent event) {
    if (takenBack) {
      takenBack = false;
      event.consume();
    } else if (drag != null) {
      AreaHandleDrag done = drag;
      drag = null;
      event.consume();
      boolean made =
          nodes.place(
              done.area().element(),
              dragged,
              done.handle() == AreaHandleDrag.MIDDLE ? "move" : "resize");
      if (!made) { // No edit follows that would reset the shown box.
        live.show(done.area(), done.area().box());
      }
      view.repaint();
    }
  }

  private void cancel() {
    if (drag != null) {
      live.show(drag.area(), drag.area().box());
      drag = null;
      takenBack = true;
      view.repaint();
    }
  }

  private void paint(Graphics2D g, PreviewFrame frame) {
    Optional<AreaInstance> selected = area();
    if (selected.isEmpty()) {
      return;
    }
    g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    AreaInstance area = selected.get();
    AreaInstance now =
        drag == null
            ? area
            : new AreaInstance(
                area.element(),
                area.name(),
                area.schemas(),
                area.frame(),
                dragged,
                area.solid(),
                area.elsewhere());
    double scale = view.scale();
    int left = view.left();
    g.clipRect(left, 0, view.getWidth() - left, view.getHeight());
    for (int handle = 0; handle < AreaHandleDrag.HANDLES; handle++) {
      int which = handle;
      AreaHandleDrag.inPicture(AreaHandleDrag.place(now, handle), frame.camera())
          .ifPresent(at -> dot(g, left + at.x / scale, at.y / scale, which));
    }
    if (drag != null) {
      AreaHandleDrag at = drag;
      AreaHandleDrag.inPicture(AreaHandleDrag.place(now, at.handle()), frame.camera())
          .ifPresent(place -> label(g, left + place.x / scale, place.y / scale, says(at, now)));
    }
  }

  private void dot(Graphics2D g, double x, double y, int handle) {
    boolean chosen = drag == null ? handle == hot : handle == drag.handle();
    double r = chosen ? RADIUS + 1.5 : RADIUS;
    var shape =
        handle == AreaHandleDrag.MIDDLE
            ? new Ellipse2D.Double(x - r, y - r, 2 * r, 2 * r)
            : new Rectangle2D.Double(x - r + 1, y - r + 1, 2 * r - 2, 2 * r - 2);
    g.setColor(chosen ? HOT : FILL);
    g.fill(shape);
    g.setColor(Color.WHITE);
    g.setStroke(new BasicStroke(1.5f));
    g.draw(shape);
  }

  private static String says(AreaHandleDrag drag, AreaInstance now) {
    if (drag.handle() == AreaHandleDrag.MIDDLE) {
      Vector3d by = now.box().centre().sub(drag.area().box().centre(), new Vector3d());
      return Texts.of("area.handle.moved", metres(by.x), metres(by.y), metres(by.z));
    }
    int axis = drag.handle() / 2;
    String side = "area.box.size." + axis;
    return Texts.of("area.handle.size", Texts.of(side), metres(now.box().size().get(axis)));
  }

  private static String metres(double value) {
    return DecimalFormatter.fixed(value, 2);
  }

  private void label(Graphics2D g, double x, double y, String text) {
    FontMetrics metrics = g.getFontMetrics();
    int width = metrics.stringWidth(text) + 8;
    int right = (int) x + 12;
    int left = right + width > view.getWidth() ? (int) x - 12 - width : right;
    int top = (int) y - metrics.getHeight() / 2;
    g.setColor(PAPER);
    g.fillRoundRect(left, top, width, metrics.getHeight() + 2, 4, 4);
    g.setColor(Color.WHITE);
    g.drawString(text, left + 4, top + 1 + metrics.getAscent());
  }
}
