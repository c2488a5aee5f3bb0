package org.selectiverenderer.enricher.tree;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import javax.swing.Icon;
import javax.swing.UIManager;

/** The icon of a kind of node, drawn as vectors and thus sharp at any scale. */
record NodeIcon(Kind kind, Mark mark) implements Icon {
  /** The kind of a node from the author's point of view. */
  public enum Kind {
    SWITCH,
    SENSOR,
    GROUP,
    SHAPE,
    METADATA,
    OTHER;

    public static Kind of(String name) {
      return switch (name) {
        case "Switch" -> SWITCH;
        case "ProximitySensor" -> SENSOR;
        case "Scene", "X3D", "Group", "Transform", "Anchor", "Collision", "LOD", "Billboard" ->
            GROUP;
        case "Shape", "Inline" -> SHAPE;
        default -> name.startsWith("Metadata") ? METADATA : OTHER;
      };
    }
  }

  /** The badge on the icon. */
  public enum Mark {
    NONE,
    ENRICHED,
    FAULTY
  }

  private static final int SIZE = 16;

  @Override
  public void paintIcon(Component c, Graphics graphics, int x, int y) {
    Graphics2D g = (Graphics2D) graphics.create();
    g.translate(x, y);
    g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
    g.setStroke(new BasicStroke(1.3f));
    g.setColor(onSelection(c) ? c.getForeground() : color(key(kind)));
    draw(g);
    if (mark != Mark.NONE) {
      drawMark(g);
    }
    g.dispose();
  }

  /** Whether it is drawn on the colour of a selected row, on which only the text's is seen. */
  private static boolean onSelection(Component c) {
    Color text = c.getForeground();
    return text != null
        && text.equals(UIManager.getColor("Tree.selectionForeground"))
        && !text.equals(UIManager.getColor("Tree.foreground"));
  }

  /** Draws the badge: a disc with a tick or a triangle, distinct by shape as well as by colour. */
  private void drawMark(Graphics2D g) {
    Path2D shape = new Path2D.Double();
    if (mark == Mark.ENRICHED) {
      g.setColor(color("Actions.Green"));
      g.fill(new Ellipse2D.Double(8.5, 8.5, 7.5, 7.5));
      g.setColor(Color.WHITE);
      shape.moveTo(10.2, 12.4);
      shape.lineTo(11.8, 14);
      shape.lineTo(14.4, 10.8);
      g.draw(shape);
    } else {
      g.setColor(color("Actions.Red"));
      shape.moveTo(12, 7.5);
      shape.lineTo(16, 15.5);
      shape.lineTo(8, 15.5);
      shape.closePath();
      g.fill(shape);
      g.setColor(Color.WHITE);
      g.fill(new Rectangle2D.Double(11.5, 10, 1, 2.8));
      g.fill(new Rectangle2D.Double(11.5, 13.5, 1, 1));
    }
  }

  private static String key(Kind kind) {
    return switch (kind) {
      case SWITCH, SENSOR -> "Actions.Blue";
      case GROUP, SHAPE, METADATA, OTHER -> "Actions.Grey";
    };
  }

  private static Color color(String key) {
    Color color = UIManager.getColor(key);
    return color == null ? Color.GRAY : color;
  }

  private void draw(Graphics2D g) {
    switch (kind) {
      case SWITCH -> {
        g.draw(new Rectangle2D.Double(2, 5, 8, 8));
        g.fill(new Rectangle2D.Double(6, 2, 8, 8));
      }
      case SENSOR -> {
        g.fill(new Ellipse2D.Double(6, 6, 4, 4));
        g.setStroke(
            new BasicStroke(1.3f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_MITER, 1, dash(), 0));
        g.draw(new Rectangle2D.Double(2, 2, 12, 12));
      }
      case GROUP -> {
        g.draw(new Rectangle2D.Double(2.5, 5, 11, 8));
        g.draw(new Rectangle2D.Double(2.5, 3, 5, 2));
      }
      case SHAPE -> g.draw(cube());
      case METADATA -> {
        g.draw(new Rectangle2D.Double(3, 3, 10, 10));
        g.draw(new Rectangle2D.Double(5.5, 6, 5, 0.1));
        g.draw(new Rectangle2D.Double(5.5, 9.5, 5, 0.1));
      }
      case OTHER -> g.draw(new Ellipse2D.Double(5.5, 5.5, 5, 5));
    }
  }

  private static float[] dash() {
    return new float[] {2.4f, 2.4f};
  }

  private static Path2D cube() {
    Path2D cube = new Path2D.Double();
    double[][] outline = {{8, 2}, {13.5, 5}, {13.5, 11}, {8, 14}, {2.5, 11}, {2.5, 5}};
    cube.moveTo(outline[0][0], outline[0][1]);
    for (double[] point : outline) {
      cube.lineTo(point[0], point[1]);
    }
    cube.closePath();
    for (int corner : new int[] {1, 3, 5}) {
      cube.moveTo(8, 8);
      cube.lineTo(outline[corner][0], outline[corner][1]);
    }
    return cube;
  }

  @Override
  public int getIconWidth() {
    return SIZE;
  }

  @Override
  public int getIconHeight() {
    return SIZE;
  }
}
