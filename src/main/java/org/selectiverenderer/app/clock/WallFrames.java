package org.selectiverenderer.app.clock;

import java.util.List;

/**
 * A frame for each picture, at the time that the clock on the wall shows; at least one.
 *
 * @param duration seconds; infinite for no end
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
