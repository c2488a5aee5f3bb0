package org.selectiverenderer.enricher.versions;

import java.util.ArrayList;
import java.util.List;

/** From where the versions are looked at: one for all of them, so that they turn together. */
final class Turntable {
  private final List<Runnable> listeners = new ArrayList<>();
  private double yaw = 0.6;
  private double pitch = 0.35;
  private double zoom = 1;

  void addListener(Runnable listener) {
    listeners.add(listener);
  }

  /** Turns by angles in radians; one does not go over the top. */
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

  /** Rows of the rotation into the picture: right, up, towards the viewer. */
  double[] rotation() {
    double sy = Math.sin(yaw);
    double cy = Math.cos(yaw);
    double sp = Math.sin(pitch);
    double cp = Math.cos(pitch);
    return new double[] {cy, 0, -sy, -sp * sy, cp, -sp * cy, cp * sy, sp, cp * cy};
  }
}
