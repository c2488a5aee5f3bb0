package org.selectiverenderer.enricher.placement;

import java.awt.BasicStroke;
import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Path2D;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import javax.swing.ButtonGroup;
import javax.swing.Icon;
import javax.swing.JToggleButton;
import org.selectiverenderer.enricher.text.Texts;

/** The buttons that choose what the handles do, and the one that measures. */
public final class HandleBar {
  private static final int SIZE = 16;

  private final HandleSettings settings;
  private final Map<HandleSettings.Mode, JToggleButton> modes =
      new EnumMap<>(HandleSettings.Mode.class);
  private final JToggleButton measure;

  /** Creates the buttons. */
  public HandleBar(HandleSettings settings) {
    this.settings = settings;
    ButtonGroup group = new ButtonGroup();
    for (HandleSettings.Mode mode : HandleSettings.Mode.values()) {
      JToggleButton button = button("mode." + mode, pathOf(mode));
      button.addActionListener(event -> settings.use(mode));
      group.add(button);
      modes.put(mode, button);
    }
    measure = button("measure", measuring());
    measure.addActionListener(event -> settings.measure(measure.isSelected()));
    settings.onChange(this::follow);
    follow();
  }

  private void follow() {
    modes.get(settings.mode()).setSelected(true);
    measure.setSelected(settings.measuring());
  }

  private static JToggleButton button(String key, Path2D drawn) {
    JToggleButton button = new JToggleButton(new Drawn(drawn));
    button.setName("placement." + key);
    button.setToolTipText(Texts.of("placement." + key + ".tip"));
    button.getAccessibleContext().setAccessibleName(Texts.of("placement." + key));
    return button;
  }

  /** The buttons in their order. */
  public List<JToggleButton> buttons() {
    return List.of(
        modes.get(HandleSettings.Mode.MOVE),
        modes.get(HandleSettings.Mode.TURN),
        modes.get(HandleSettings.Mode.SCALE),
        measure);
  }

  private static Path2D pathOf(HandleSettings.Mode mode) {
    Path2D path = new Path2D.Double();
    switch (mode) {
      case MOVE -> {
        line(path, 8, 1, 8, 15);
        line(path, 1, 8, 15, 8);
        line(path, 6, 3, 8, 1, 10, 3);
        line(path, 6, 13, 8, 15, 10, 13);
        line(path, 3, 6, 1, 8, 3, 10);
        line(path, 13, 6, 15, 8, 13, 10);
      }
      case TURN -> {
        for (int i = 0; i <= 20; i++) {
          double angle = Math.toRadians(-60 + i * 15);
          double x = 8 + 6 * Math.sin(angle);
          double y = 8 - 6 * Math.cos(angle);
          if (i == 0) {
            path.moveTo(x, y);
          } else {
            path.lineTo(x, y);
          }
        }
        line(path, 2, 1, 2.8, 5, 6.8, 4.6);
      }
      case SCALE -> {
        line(path, 2, 7, 2, 14, 9, 14, 9, 7, 2, 7);
        line(path, 9, 7, 14.5, 1.5);
        line(path, 10, 1.5, 14.5, 1.5, 14.5, 6);
      }
    }
    return path;
  }

  private static Path2D measuring() {
    Path2D path = new Path2D.Double();
    line(path, 1, 5, 15, 5, 15, 11, 1, 11, 1, 5);
    line(path, 4, 5, 4, 8);
    line(path, 7, 5, 7, 7);
    line(path, 10, 5, 10, 8);
    line(path, 13, 5, 13, 7);
    return path;
  }

  private static void line(Path2D path, double... points) {
    path.moveTo(points[0], points[1]);
    for (int i = 2; i + 1 < points.length; i += 2) {
      path.lineTo(points[i], points[i + 1]);
    }
  }

  private record Drawn(Path2D path) implements Icon {
    @Override
    public void paintIcon(Component over, Graphics graphics, int x, int y) {
      Graphics2D g = (Graphics2D) graphics.create();
      g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
      g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
      g.translate(x, y);
      g.setColor(over.getForeground());
      g.setStroke(new BasicStroke(1.4f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
      g.draw(path);
      g.dispose();
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
}
