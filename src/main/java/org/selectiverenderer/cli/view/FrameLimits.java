package org.selectiverenderer.cli.view;

import org.selectiverenderer.app.clock.EvenFrames;
import org.selectiverenderer.cli.output.CommandFailure;
import org.selectiverenderer.runtime.viewer.CameraPath;

/** Rejects paths and frame rates with an implausible number of frames. */
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
