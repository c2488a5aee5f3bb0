package org.selectiverenderer.app.clock;

import java.util.List;

/**
 * A frame clock with one frame for each picture, at the real time that has elapsed; it has at least
 * one frame.
 *
 * @param duration seconds after which the run ends; infinite for no end
 */
record WallFrames(double duration) implements FrameClock {
  @Override
  public List<Double> due(double elapsed) {
    return List.of(elapsed);
  }

  @Override
  public boolean over(double elapsed) {
    return elapsed >= duration;
  }
}
