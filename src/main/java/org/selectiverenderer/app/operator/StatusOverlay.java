package org.selectiverenderer.app.operator;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.browser.viewer.Viewer;
import org.selectiverenderer.render.FrameStatistics;
import org.selectiverenderer.walkthrough.Walkthrough;

/** The status lines over the picture, which the user shows and hides with F1. */
public final class StatusOverlay {
  private static final double SMOOTHING = 0.1;

  private boolean shown;
  private double interval;
  private long lastFrame;
  private FrameStatistics drawn = new FrameStatistics(0, 0);

  /** Shows it if it is hidden, else hides it. */
  public void toggle() {
    shown = !shown;
  }

  /** A frame was drawn. */
  public void frame(FrameStatistics frame) {
    long now = System.nanoTime();
    if (lastFrame != 0) {
      double seconds = (now - lastFrame) * 1e-9;
      interval = interval == 0 ? seconds : interval + SMOOTHING * (seconds - interval);
    }
    lastFrame = now;
    drawn = frame;
  }

  /** Returns the smoothed frame interval in seconds; 0 before the second frame. */
  public double interval() {
    return interval;
  }

  /**
   * Returns the lines of the overlay; empty when the overlay is hidden.
   *
   * @param navigation the navigation type as text; empty when the user does not navigate
   */
  public List<String> lines(Walkthrough walk, String navigation) {
    List<String> lines = new ArrayList<>();
    if (!shown) {
      return lines;
    }
    lines.add(text("%.0f frames/s  (%.1f ms)", interval == 0 ? 0 : 1 / interval, interval * 1000));
    lines.add(text("%,d polygons in the scene, %,d drawn", walk.polygons(), drawn.triangles()));
    walk.budget()
        .ifPresent(
            budget ->
                lines.add(text("budget %s: %,d polygons", budget.budget(), budget.triangles())));
    Viewer viewer = walk.world().viewer();
    Vector3dc eye = viewer.position();
    Vector3d ahead = viewer.orientation().transform(new Vector3d(0, 0, -1));
    lines.add(
        text(
            "position %.2f  %.2f  %.2f   yaw %.0f\u00b0  pitch %.0f\u00b0",
            eye.x(),
            eye.y(),
            eye.z(),
            degrees(Math.atan2(-ahead.x, -ahead.z)),
            degrees(Math.asin(Math.max(-1, Math.min(1, ahead.y))))));
    lines.add("areas entered: " + list(walk.enteredAreas()));
    lines.add("schemas active: " + list(walk.activeSchemas()));
    if (!navigation.isEmpty()) {
      lines.add(navigation);
    }
    return lines;
  }

  /** Returns whole degrees, with 0 instead of -0. */
  private static double degrees(double radians) {
    return Math.rint(Math.toDegrees(radians)) + 0.0;
  }

  private static String list(List<String> names) {
    return names.isEmpty() ? "none" : String.join(", ", names);
  }

  private static String text(String format, Object... arguments) {
    return String.format(Locale.ROOT, format, arguments);
  }
}
