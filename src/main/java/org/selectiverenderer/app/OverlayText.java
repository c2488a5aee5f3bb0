package org.selectiverenderer.app;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.runtime.navigation.Viewer;
import org.selectiverenderer.runtime.render.Drawn;

/** The lines of the overlay (F1). */
final class OverlayText {
  private static final double SMOOTHING = 0.1;

  private double interval;
  private long lastFrame;
  private Drawn drawn = new Drawn(0, 0);

  /** A frame was drawn. */
  void frame(Drawn frame) {
    long now = System.nanoTime();
    if (lastFrame != 0) {
      double seconds = (now - lastFrame) * 1e-9;
      interval = interval == 0 ? seconds : interval + SMOOTHING * (seconds - interval);
    }
    lastFrame = now;
    drawn = frame;
  }

  /** Seconds from frame to frame, smoothed; 0 before the second frame. */
  double interval() {
    return interval;
  }

  List<String> lines(Walkthrough walk, String navigation) {
    List<String> lines = new ArrayList<>();
    lines.add(text("%.0f frames/s  (%.1f ms)", interval == 0 ? 0 : 1 / interval, interval * 1000));
    lines.add(text("%,d polygons in the scene, %,d drawn", walk.polygons(), drawn.triangles()));
    Viewer viewer = walk.world().viewer();
    Vector3dc eye = viewer.position();
    Vector3d ahead = viewer.orientation().transform(new Vector3d(0, 0, -1));
    lines.add(
        text(
            "position %.2f  %.2f  %.2f   yaw %.0f\u00b0  pitch %.0f\u00b0",
            eye.x(),
            eye.y(),
            eye.z(),
            Math.toDegrees(Math.atan2(-ahead.x, -ahead.z)),
            Math.toDegrees(Math.asin(Math.max(-1, Math.min(1, ahead.y))))));
    lines.add("areas entered: " + list(walk.enteredAreas()));
    lines.add("schemas active: " + list(walk.activeSchemas()));
    if (!navigation.isEmpty()) {
      lines.add(navigation);
    }
    return lines;
  }

  private static String list(List<String> names) {
    return names.isEmpty() ? "none" : String.join(", ", names);
  }

  private static String text(String format, Object... arguments) {
    return String.format(Locale.ROOT, format, arguments);
  }
}
