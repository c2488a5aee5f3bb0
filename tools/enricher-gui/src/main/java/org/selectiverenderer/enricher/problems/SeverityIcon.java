package org.selectiverenderer.enricher.problems;

import java.awt.Color;
import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import javax.swing.Icon;
import javax.swing.UIManager;
import org.selectiverenderer.x3d.Problem;

/** A drawn sign of how bad a problem is: circle, triangle or ring. */
record SeverityIcon(Problem.Severity severity) implements Icon {
  private static final int SIZE = 16;

  @Override
  public void paintIcon(Component c, Graphics graphics, int x, int y) {
    Graphics2D g = (Graphics2D) graphics.create();
    g.translate(x, y);
    g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    switch (severity) {
      case ERROR -> {
        g.setColor(color("Actions.Red"));
        g.fill(new Ellipse2D.Double(3, 3, 10, 10));
      }
      case WARNING -> {
        g.setColor(color("Actions.Yellow"));
        Path2D triangle = new Path2D.Double();
        triangle.moveTo(8, 2);
        triangle.lineTo(14.5, 13.5);
        triangle.lineTo(1.5, 13.5);
        triangle.closePath();
        g.fill(triangle);
      }
      case INFO -> {
        g.setColor(color("Actions.Blue"));
        g.draw(new Ellipse2D.Double(3.5, 3.5, 9, 9));
      }
    }
    g.dispose();
  }

  private static Color color(String key) {
    Color color = UIManager.getColor(key);
    return color == null ? Color.GRAY : color;
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
