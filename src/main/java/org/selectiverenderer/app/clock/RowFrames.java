package org.selectiverenderer.app.clock;

import org.selectiverenderer.runtime.viewer.CameraPath;

/**
 * A schedule with one frame for each row of a path.
 *
 * @param end seconds after which rows are left out; the first row always counts
 */
record RowFrames(CameraPath path, double end) implements FrameSchedule {
  @Override
  public boolean has(long frame) {
    return frame < path.rows() && (frame == 0 || time(frame) <= end);
  }

  @Override
  public double time(long frame) {
    return path.time((int) frame);
  }
}
