package org.selectiverenderer.enricher.preview;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.SwingUtilities;
import org.joml.Vector2d;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.collision.RayCaster;
import org.selectiverenderer.enricher.placement.Distance;
import org.selectiverenderer.enricher.placement.HandleSettings;
import org.selectiverenderer.enricher.text.Texts;

/** Measures the distance between two points that the author clicks in the picture. */
final class MeasureOverlay {
  private static final Color LINE = new Color(0xffd000);

  private final PreviewCanvas view;
  private final PreviewThread thread;
  private final List<Vector3dc> points = new ArrayList<>();
  private @Nullable HandleSettings settings;

  MeasureOverlay(PreviewCanvas view, PreviewThread thread) {
    this.view = view;
    this.thread = thread;
    view.overlay(this::paint);
  }

  void settings(HandleSettings use) {
    settings = use;
    use.onChange(
        () -> {
          if (!use.measuring()) {
            points.clear();
          }
          view.repaint();
        });
  }

  /** Whether clicks measure. */
  boolean active() {
    return settings != null && settings.measuring();
  }

  /** Ends measuring. */
  void end() {
    if (settings != null && settings.measuring()) {
      settings.measure(false);
    }
  }

  /** Takes the point of the surface under a pixel; a third one begins anew. */
  void click(int pixelX, int pixelY) {
    thread.ask(
        stage -> {
          Optional<Vector3dc> hit = stage.cast(pixelX, pixelY).map(RayCaster.Hit::point);
          SwingUtilities.invokeLater(() -> hit.ifPresent(this::add));
        });
  }

  private void add(Vector3dc point) {
    if (active()) {
      if (points.size() > 1) {
        points.clear();
      }
      points.add(new Vector3d(point));
      view.repaint();
    }
  }

  /** The words about what is measured. */
  String words() {
    return switch (points.size()) {
      case 0 -> Texts.of("placement.measure.first");
      case 1 -> Texts.of("placement.measure.second");
      default -> Distance.words(points.get(0), points.get(1));
    };
  }

  private void paint(Graphics2D g, PreviewFrame frame) {
    if (!active() || frame.walking()) {
      return;
    }
    g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    PictureRays rays = new PictureRays(frame.camera());
    double scale = view.scale();
    List<Vector2d> seen = new ArrayList<>();
    for (Vector3dc point : points) {
      rays.project(point)
          .ifPresent(at -> seen.add(new Vector2d(view.left() + at.x / scale, at.y / scale)));
    }
    g.setColor(LINE);
    g.setStroke(new BasicStroke(2));
    seen.forEach(at -> g.fill(new Ellipse2D.Double(at.x - 4, at.y - 4, 8, 8)));
    int x = view.left() + 12;
    int y = 12;
    if (seen.size() == 2) {
      Vector2d a = seen.get(0);
      Vector2d b = seen.get(1);
      g.draw(new Line2D.Double(a.x, a.y, b.x, b.y));
      x = (int) ((a.x + b.x) / 2) + 8;
      y = (int) ((a.y + b.y) / 2) + 8;
    }
    ObjectHandlePainter.label(g, words(), x, y, view.getWidth(), view.getHeight());
  }
}
