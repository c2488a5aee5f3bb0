package org.selectiverenderer.cli.view;

import org.selectiverenderer.app.clock.EvenFrames;
import org.selectiverenderer.cli.output.CommandFailure;
import org.selectiverenderer.runtime.viewer.CameraPath;

/** Refuses paths and rates of more frames than anybody can mean. */
final class FrameLimits {
  private FrameLimits() {}

  static void check(CameraPath path, double rate) {
    try {
      new EvenFrames(path.start(), path.end(), rate);
    } catch (IllegalArgumentException e) {
      throw CommandFailure.usage(e.getMessage());
    }
  }
}
