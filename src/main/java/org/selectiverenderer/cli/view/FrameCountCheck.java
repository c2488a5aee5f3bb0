package org.selectiverenderer.cli.view;

import org.selectiverenderer.app.clock.FixedRateSchedule;
import org.selectiverenderer.browser.viewer.CameraPath;
import org.selectiverenderer.command.output.CommandException;

/** Rejects paths and frame rates with an implausible number of frames. */
final class FrameCountCheck {
  private FrameCountCheck() {}

  static void check(CameraPath path, double rate) {
    try {
      new FixedRateSchedule(path.start(), path.end(), rate);
    } catch (IllegalArgumentException e) {
      throw CommandException.usage(e.getMessage());
    }
  }
}
