package org.selectiverenderer.enricher.preview;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.MouseInfo;
import java.awt.Point;
import java.awt.PointerInfo;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.Optional;
import javax.swing.SwingUtilities;
import org.joml.Vector2d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.enricher.area.ObjectBox;
import org.selectiverenderer.geometry.BoundingBox;

/** Paints the handles and boxes of the selected objects over the picture. */
final class ObjectHandlePainter {
  private static final Color[] AXES = {
    new Color(0xf0524a), new Color(0x4fbf4f), new Color(0x4f8cff)
  };
  private static final Color HOT = new Color(0xffd000);
  private static final Color FILL = new Color(0xff8c00);
  private static final Color BOX = new Color(255, 140, 0, 190);
  private static final Color EDGE = new Color(0, 0, 0, 150);
  private static final Color PAPER = new Color(0, 0, 0, 170);

  /** The corners of a box that its twelve edges join. */
  private static final int[][] EDGES = {
    {0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3}, {4, 6}, {5, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}
  };

  private final PreviewCanvas view;

  ObjectHandlePainter(PreviewCanvas view) {
    this.view = view;
  }

  /**
   * @param words beside the mouse; empty for none
   */
  void paint(
      Graphics2D g,
      PictureRays rays,
      List<ObjectBox> boxes,
      List<ObjectHandle> handles,
      @Nullable ObjectHandle hot,
      Optional<String> words) {
    g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    Shape clip = g.getClip();
    int left = view.left();
    g.clipRect(left, 0, view.getWidth() - left, view.getHeight());
    if (words.isPresent() || boxes.size() > 1) {
      boxes.forEach(box -> box(g, rays, box));
    }
    for (int i = handles.size() - 1; i >= 0; i--) {
      ObjectHandle handle = handles.get(i);
      handle(g, handle, hot != null && hot.same(handle));
    }
    words.ifPresent(text -> label(g, text));
    g.setClip(clip);
  }

  private Vector2d screen(Vector2d pixels) {
    double scale = view.scale();
    return new Vector2d(view.left() + pixels.x / scale, pixels.y / scale);
  }

  private void box(Graphics2D g, PictureRays rays, ObjectBox box) {
    BoundingBox own = box.own();
    g.setColor(BOX);
    g.setStroke(new BasicStroke(1.2f));
    for (int[] edge : EDGES) {
      Optional<Vector2d> a = rays.project(box.place().transformPosition(own.corner(edge[0])));
      Optional<Vector2d> b = rays.project(box.place().transformPosition(own.corner(edge[1])));
      if (a.isPresent() && b.isPresent()) {
        Vector2d from = screen(a.get());
        Vector2d to = screen(b.get());
        g.draw(new Line2D.Double(from.x, from.y, to.x, to.y));
      }
    }
  }

  private void handle(Graphics2D g, ObjectHandle handle, boolean hot) {
    boolean plain =
        handle.kind() == ObjectHandle.Kind.SURFACE || handle.kind() == ObjectHandle.Kind.CORNER;
    Color colour = hot ? HOT : plain ? FILL : AXES[handle.axis()];
    double scale = view.scale();
    AffineTransform to = AffineTransform.getTranslateInstance(view.left(), 0);
    to.scale(1 / scale, 1 / scale);
    Path2D outline = handle.outline();
    outline.transform(to);
    switch (handle.kind()) {
      case PLANE -> {
        g.setColor(new Color(colour.getRed(), colour.getGreen(), colour.getBlue(), 110));
        g.fill(outline);
        g.setColor(colour);
        g.setStroke(new BasicStroke(1));
        g.draw(outline);
      }
      case AXIS, RING -> {
        g.setStroke(new BasicStroke(hot ? 6 : 4.5f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        g.setColor(EDGE);
        g.draw(outline);
        g.setStroke(new BasicStroke(hot ? 4 : 2.5f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        g.setColor(colour);
        g.draw(outline);
        if (handle.kind() == ObjectHandle.Kind.AXIS) {
          arrow(g, screen(handle.points().get(0)), screen(handle.points().get(1)));
        }
      }
      case SURFACE -> dot(g, screen(handle.points().get(0)), colour, true, hot ? 8 : 6.5);
      case FACE -> dot(g, screen(handle.points().get(0)), colour, false, hot ? 7 : 5.5);
      case CORNER -> dot(g, screen(handle.points().get(0)), colour, false, hot ? 5.5 : 4);
    }
  }

  private static void arrow(Graphics2D g, Vector2d from, Vector2d to) {
    Vector2d way = new Vector2d(to).sub(from);
    if (way.length() < 4) {
      return;
    }
    way.normalize();
    Path2D head = new Path2D.Double();
    head.moveTo(to.x + 10 * way.x, to.y + 10 * way.y);
    head.lineTo(to.x - 5 * way.y, to.y + 5 * way.x);
    head.lineTo(to.x + 5 * way.y, to.y - 5 * way.x);
    head.closePath();
    g.fill(head);
  }

  private static void dot(Graphics2D g, Vector2d at, Color colour, boolean round, double r) {
    Shape shape =
        round
            ? new Ellipse2D.Double(at.x - r, at.y - r, 2 * r, 2 * r)
            : new Rectangle2D.Double(at.x - r, at.y - r, 2 * r, 2 * r);
    g.setColor(colour);
    g.fill(shape);
    g.setColor(Color.WHITE);
    g.setStroke(new BasicStroke(1.5f));
    g.draw(shape);
  }

  private void label(Graphics2D g, String text) {
    PointerInfo pointer = MouseInfo.getPointerInfo();
    Point at = pointer == null ? new Point() : pointer.getLocation();
    SwingUtilities.convertPointFromScreen(at, view);
    label(g, text, at.x + 16, at.y + 4, view.getWidth(), view.getHeight());
  }

  /** Paints words on a dark ground, within a width and a height. */
  static void label(Graphics2D g, String text, int x, int y, int most, int lowest) {
    FontMetrics metrics = g.getFontMetrics();
    int width = metrics.stringWidth(text) + 8;
    int height = metrics.getHeight() + 2;
    int left = Math.max(0, Math.min(x, most - width));
    int top = Math.max(0, Math.min(y, lowest - height));
    g.setColor(PAPER);
    g.fillRoundRect(left, top, width, height, 4, 4);
    g.setColor(Color.WHITE);
    g.drawString(text, left + 4, top + 1 + metrics.getAscent());
  }
}
