package org.selectiverenderer.cli;

import org.selectiverenderer.app.PathClock;
import org.selectiverenderer.runtime.navigation.CameraPath;

/** Refuses paths and rates of more frames than anybody can mean. */
final class Frames {
  private Frames() {}

  static void check(CameraPath path, double rate) {
    try {
      new PathClock(path.start(), path.end(), rate);
    } catch (IllegalArgumentException e) {
      throw CommandFailure.usage(e.getMessage());
    }
  }
}
