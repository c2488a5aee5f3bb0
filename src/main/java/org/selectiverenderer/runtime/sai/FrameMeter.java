package org.selectiverenderer.runtime.sai;

import org.joml.Vector3d;
import org.selectiverenderer.runtime.World;

/** Measures the frame rate and the viewer's speed. Read from any thread. */
final class FrameMeter {
  private static final double SMOOTHING = 0.1;

  private final World world;
  private final Vector3d last = new Vector3d();
  private long lastNanos;
  private double lastTime = Double.NaN;
  private volatile double interval;
  private volatile double speed;

  FrameMeter(World world) {
    this.world = world;
    world.onStep(this::frame);
  }

  private void frame() {
    long now = System.nanoTime();
    if (!Double.isNaN(lastTime)) {
      double seconds = (now - lastNanos) * 1e-9;
      interval = interval == 0 ? seconds : interval + SMOOTHING * (seconds - interval);
      double dt = world.time() - lastTime;
      speed = dt > 0 ? last.distance(world.viewer().position()) / dt : 0;
    }
    lastNanos = now;
    lastTime = world.time();
    last.set(world.viewer().position());
  }

  /** Returns the frames per second of wall-clock time, smoothed over about ten frames. */
  double framesPerSecond() {
    return interval == 0 ? 0 : 1 / interval;
  }

  /**
   * Returns the viewer's speed over the last frame, in units of length per second of the scene's
   * time.
   */
  double speed() {
    return speed;
  }
}
