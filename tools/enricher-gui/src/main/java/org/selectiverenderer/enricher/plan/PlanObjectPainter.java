package org.selectiverenderer.enricher.plan;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.enricher.area.ObjectBox;
import org.selectiverenderer.enricher.placement.Distance;
import org.selectiverenderer.enricher.text.Texts;

/** Paints the selected objects of the plan, their handles, and what is measured. */
final class PlanObjectPainter {
  private static final Color SELECTED = new Color(0xff8c00);
  private static final Color FILL = new Color(255, 140, 0, 40);
  private static final Color X = new Color(0xf0524a);
  private static final Color Z = new Color(0x4f8cff);
  private static final Color Y = new Color(0x4fbf4f);
  private static final Color PAPER = new Color(0, 0, 0, 170);
  private static final Color MEASURE = new Color(0xe0a000);

  /** The corners of a box that its twelve edges join. */
  private static final int[][] EDGES = {
    {0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3}, {4, 6}, {5, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}
  };

  private final FloorPlanCanvas view;
  private final PlanObjects objects;

  PlanObjectPainter(FloorPlanCanvas view, PlanObjects objects) {
    this.view = view;
    this.objects = objects;
  }

  void paint(Graphics2D g) {
    PlanTransform at = view.scale();
    for (ObjectBox box : objects.boxes()) {
      outline(g, at, box);
    }
    objects.handles().forEach(handle -> handle(g, handle));
    objects
        .rectangle()
        .ifPresent(
            area -> {
              g.setColor(FILL);
              g.fill(area);
              g.setColor(SELECTED);
              g.setStroke(
                  new BasicStroke(
                      1, BasicStroke.CAP_BUTT, BasicStroke.JOIN_MITER, 10, new float[] {4, 3}, 0));
              g.draw(area);
            });
    objects.words().ifPresent(words -> besideMouse(g, words));
    if (objects.settings().measuring()) {
      measured(g, at, objects.measured());
    }
  }

  private static void outline(Graphics2D g, PlanTransform at, ObjectBox box) {
    g.setColor(SELECTED);
    g.setStroke(new BasicStroke(2));
    for (int[] edge : EDGES) {
      Vector3d a = box.place().transformPosition(box.own().corner(edge[0]));
      Vector3d b = box.place().transformPosition(box.own().corner(edge[1]));
      g.draw(new Line2D.Double(at.toX(a.x), at.toY(a.z), at.toX(b.x), at.toY(b.z)));
    }
  }

  private static void handle(Graphics2D g, PlanHandle handle) {
    double x = handle.x();
    double y = handle.y();
    switch (handle.kind()) {
      case MOVE -> dot(g, x, y, 7, true);
      case MOVE_X -> arrow(g, x - PlanHandle.LENGTH + 9, y, x, y, X);
      case MOVE_Z -> arrow(g, x, y - PlanHandle.LENGTH + 9, x, y, Z);
      case TURN -> {
        double r = PlanHandle.LENGTH;
        g.setColor(Y);
        g.setStroke(new BasicStroke(3));
        g.draw(new Ellipse2D.Double(x - r, y - r, 2 * r, 2 * r));
      }
      case SIDE -> dot(g, x, y, 5.5, false);
      case CORNER -> dot(g, x, y, 4, false);
    }
  }

  private static void dot(Graphics2D g, double x, double y, double r, boolean round) {
    Shape shape =
        round
            ? new Ellipse2D.Double(x - r, y - r, 2 * r, 2 * r)
            : new Rectangle2D.Double(x - r, y - r, 2 * r, 2 * r);
    g.setColor(SELECTED);
    g.fill(shape);
    g.setColor(Color.WHITE);
    g.setStroke(new BasicStroke(1.5f));
    g.draw(shape);
  }

  private static void arrow(
      Graphics2D g, double fromX, double fromY, double x, double y, Color colour) {
    g.setColor(colour);
    g.setStroke(new BasicStroke(3));
    g.draw(new Line2D.Double(fromX, fromY, x, y));
    double length = Math.hypot(x - fromX, y - fromY);
    double ux = (x - fromX) / length;
    double uy = (y - fromY) / length;
    Path2D head = new Path2D.Double();
    head.moveTo(x + 10 * ux, y + 10 * uy);
    head.lineTo(x - 5 * uy, y + 5 * ux);
    head.lineTo(x + 5 * uy, y - 5 * ux);
    head.closePath();
    g.fill(head);
  }

  private void measured(Graphics2D g, PlanTransform at, List<Vector3dc> points) {
    g.setColor(MEASURE);
    g.setStroke(new BasicStroke(2));
    for (Vector3dc point : points) {
      g.fill(new Ellipse2D.Double(at.toX(point.x()) - 4, at.toY(point.z()) - 4, 8, 8));
    }
    if (points.size() < 2) {
      label(g, Texts.of("placement.measure." + (points.isEmpty() ? "first" : "second")), 12, 12);
      return;
    }
    Vector3dc a = points.get(0);
    Vector3dc b = points.get(1);
    g.draw(new Line2D.Double(at.toX(a.x()), at.toY(a.z()), at.toX(b.x()), at.toY(b.z())));
    label(
        g,
        Distance.words(a, b),
        (int) at.toX((a.x() + b.x()) / 2) + 8,
        (int) at.toY((a.z() + b.z()) / 2) + 8);
  }

  private void besideMouse(Graphics2D g, String words) {
    Point at = view.getMousePosition();
    label(g, words, at == null ? 12 : at.x + 16, at == null ? 12 : at.y + 4);
  }

  private void label(Graphics2D g, String text, int x, int y) {
    FontMetrics metrics = g.getFontMetrics();
    int width = metrics.stringWidth(text) + 8;
    int left = Math.max(0, Math.min(x, view.getWidth() - width));
    int top = Math.max(0, Math.min(y, view.getHeight() - metrics.getHeight() - 2));
    g.setColor(PAPER);
    g.fillRoundRect(left, top, width, metrics.getHeight() + 2, 4, 4);
    g.setColor(Color.WHITE);
    g.drawString(text, left + 4, top + 1 + metrics.getAscent());
  }
}
