package org.selectiverenderer.app.clock;

import org.selectiverenderer.runtime.viewer.CameraPath;

/**
 * The rows of a path.
 *
 * @param end seconds after which no row counts but the first
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
