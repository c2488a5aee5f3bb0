package org.selectiverenderer.app;

import org.selectiverenderer.runtime.navigation.CameraPath;
import org.selectiverenderer.runtime.navigation.PathMotion;
import org.selectiverenderer.runtime.navigation.ViewerMotion;

/** Walks a recorded path through a scene without a picture. */
public final class Simulation {
  private Simulation() {}

  /** Steps every frame of the path and tells the end. */
  public static void run(Walkthrough walk, CameraPath path, double rate) {
    PathClock clock = new PathClock(path.start(), path.end(), rate);
    ViewerMotion motion = new PathMotion(path, 0);
    for (long frame = 0; frame < clock.frames(); frame++) {
      walk.step(clock.time(frame), motion);
    }
    walk.end();
  }
}
