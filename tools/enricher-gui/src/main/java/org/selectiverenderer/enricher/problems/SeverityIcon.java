package org.selectiverenderer.enricher.problems;

import com.formdev.flatlaf.icons.FlatAbstractIcon;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Component;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import javax.swing.JLabel;
import javax.swing.UIManager;
import org.selectiverenderer.base.problem.Problem.Severity;
import org.selectiverenderer.enricher.text.Texts;

/** The icon of a severity, by shape as well as by colour: a cross in a disc, a triangle, a ring. */
public final class SeverityIcon extends FlatAbstractIcon {
  private static final int SIZE = 16;

  private final Severity severity;

  public SeverityIcon(Severity severity) {
    super(SIZE, SIZE, null);
    this.severity = severity;
  }

  /** Creates a label with the icon and an accessible name. */
  public static JLabel label(Severity severity) {
    JLabel label = new JLabel(new SeverityIcon(severity));
    label.getAccessibleContext().setAccessibleName(word(severity));
    label.setToolTipText(word(severity));
    return label;
  }

  /** The severity as a word. */
  public static String word(Severity severity) {
    return switch (severity) {
      case ERROR -> Texts.of("problems.error");
      case WARNING -> Texts.of("problems.warning");
      case INFO -> Texts.of("problems.remark");
    };
  }

  @Override
  protected void paintIcon(Component component, Graphics2D g) {
    g.setColor(color());
    switch (severity) {
      case ERROR -> {
        g.fill(new Ellipse2D.Double(2, 2, 12, 12));
        g.setColor(Color.WHITE);
        g.setStroke(new BasicStroke(1.6f));
        g.draw(new Line2D.Double(5.5, 5.5, 10.5, 10.5));
        g.draw(new Line2D.Double(10.5, 5.5, 5.5, 10.5));
      }
      case WARNING -> {
        Path2D triangle = new Path2D.Double();
        triangle.moveTo(8, 1.5);
        triangle.lineTo(15, 14);
        triangle.lineTo(1, 14);
        triangle.closePath();
        g.fill(triangle);
        g.setColor(Color.BLACK);
        g.setStroke(new BasicStroke(1.6f));
        g.draw(new Line2D.Double(8, 6, 8, 9.5));
        g.fill(new Ellipse2D.Double(7.1, 11, 1.8, 1.8));
      }
      case INFO -> {
        g.setStroke(new BasicStroke(1.5f));
        g.draw(new Ellipse2D.Double(2.5, 2.5, 11, 11));
        g.draw(new Line2D.Double(8, 7.5, 8, 11));
        g.fill(new Ellipse2D.Double(7.1, 4.4, 1.8, 1.8));
      }
    }
  }

  private Color color() {
    Color color =
        UIManager.getColor(
            switch (severity) {
              case ERROR -> "Actions.Red";
              case WARNING -> "Actions.Yellow";
              case INFO -> "Actions.Blue";
            });
    return color == null ? UIManager.getColor("Label.foreground") : color;
  }
}
