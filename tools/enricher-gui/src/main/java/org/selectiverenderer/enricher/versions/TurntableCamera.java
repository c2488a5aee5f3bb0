package org.selectiverenderer.enricher.versions;

import java.util.ArrayList;
import java.util.List;

/** The turntable camera that all views of versions share, so that they turn together. */
final class TurntableCamera {
  private final List<Runnable> listeners = new ArrayList<>();
  private double yaw = 0.6;
  private double pitch = 0.35;
  private double zoom = 1;

  void addListener(Runnable listener) {
    listeners.add(listener);
  }

  /** Turns by angles in radians; the pitch is limited to straight up and down. */
  void turn(double right, double up) {
    yaw += right;
    pitch = Math.max(-Math.PI / 2, Math.min(Math.PI / 2, pitch + up));
    listeners.forEach(Runnable::run);
  }

  void zoom(double factor) {
    zoom = Math.max(0.2, Math.min(20, zoom * factor));
    listeners.forEach(Runnable::run);
  }

  double zoom() {
    return zoom;
  }

  /** Returns the rows of the rotation matrix into the view: right, up, towards the viewer. */
  double[] rotation() {
    double sy = Math.sin(yaw);
    double cy = Math.cos(yaw);
    double sp = Math.sin(pitch);
    double cp = Math.cos(pitch);
    return new double[] {cy, 0, -sy, -sp * sy, cp, -sp * cy, cp * sy, sp, cp * cy};
  }
}
