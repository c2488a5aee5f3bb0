package org.selectiverenderer.tracker.pipeline;

import org.joml.Quaterniond;
import org.selectiverenderer.tracker.PoseSample;

/**
 * Predicts the orientation of the head a fixed time ahead, by constant angular velocity (Azuma and
 * Bishop, SIGGRAPH 1994).
 */
final class PredictionFilter implements PoseFilter {
  /**
   * Minimum interval in seconds over which the velocity is measured: for records that arrive
   * together it would be infinite, and noise would make it large.
   */
  private static final double BASELINE = 0.02;

  /** Gap in seconds after which the velocity is unknown. */
  private static final double LONGEST_GAP = 0.1;

  private static final int HISTORY = 64;

  private final double ahead;
  private final Quaterniond[] past = new Quaterniond[HISTORY];
  private final long[] times = new long[HISTORY];
  private final Quaterniond now = new Quaterniond();
  private final Quaterniond turn = new Quaterniond();
  private int count;

  /**
   * @param ahead prediction time in seconds
   */
  PredictionFilter(double ahead) {
    this.ahead = ahead;
    for (int i = 0; i < HISTORY; i++) {
      past[i] = new Quaterniond();
    }
  }

  @Override
  public void apply(PoseSample sample) {
    sample.orientation(now);
    long time = sample.arrival();
    if (count > 0 && seconds(count - 1, time) > LONGEST_GAP) {
      count = 0;
    }
    if (count > 0) {
      int reference = reference(time);
      double dt = seconds(reference, time);
      if (dt >= BASELINE / 2) {
        turnOn(past[reference % HISTORY], ahead / dt);
        sample.turn(turn.x, turn.y, turn.z, turn.w);
      }
    }
    past[count % HISTORY].set(now);
    times[count % HISTORY] = time;
    count++;
  }

  /**
   * Returns the latest record that is at least {@link #BASELINE} old, else the oldest in the
   * history.
   */
  private int reference(long time) {
    int oldest = Math.max(0, count - HISTORY);
    int at = count - 1;
    while (at > oldest && seconds(at, time) < BASELINE) {
      at--;
    }
    return at;
  }

  /** Extrapolates the rotation from {@code then} to {@code now} by a factor. */
  private void turnOn(Quaterniond then, double factor) {
    now.mul(turn.set(then).conjugate(), turn); // now * then^-1, in the world's frame
    if (turn.w < 0) {
      turn.set(-turn.x, -turn.y, -turn.z, -turn.w);
    }
    double sine = Math.sqrt(turn.x * turn.x + turn.y * turn.y + turn.z * turn.z);
    if (sine < 1e-12) {
      turn.set(now);
      return;
    }
    double half = Math.atan2(sine, turn.w) * factor;
    double scale = Math.sin(half) / sine;
    turn.set(turn.x * scale, turn.y * scale, turn.z * scale, Math.cos(half));
    turn.mul(now).normalize();
  }

  private double seconds(int index, long time) {
    return (time - times[index % HISTORY]) * 1e-9;
  }
}
