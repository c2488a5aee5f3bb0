package org.selectiverenderer.tracker;

import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * Options for the records of any tracker, applied in this order: swap, invert, smooth, predict.
 *
 * @param swapped the two angles that are exchanged; empty for none
 * @param inverted the angles whose sign is inverted, after swapping
 * @param smoothing filter against jitter, at the cost of some delay; empty (the default) for none
 * @param prediction prediction time in seconds: the known motion-to-photon latency; 0 (the default)
 *     for none, at most 0.1
 */
public record TrackerOptions(
    Optional<Swap> swapped,
    Set<EulerAngle> inverted,
    Optional<Smoothing> smoothing,
    double prediction) {
  /** Maximum prediction time in seconds; a head may have stopped and turned back by then. */
  public static final double LONGEST_PREDICTION = 0.1;

  /** Options that do not change records. */
  public static final TrackerOptions NONE =
      new TrackerOptions(Optional.empty(), Set.of(), Optional.empty(), 0);

  /**
   * @throws IllegalArgumentException if the prediction is out of range
   */
  public TrackerOptions {
    inverted = Set.copyOf(inverted);
    if (!(prediction >= 0 && prediction <= LONGEST_PREDICTION)) {
      throw new IllegalArgumentException(
          "a prediction must be between 0 and 100 ms, not " + prediction * 1000);
    }
  }

  /** Returns whether the options change records. */
  public boolean change() {
    return swapped.isPresent() || !inverted.isEmpty() || smoothing.isPresent() || prediction > 0;
  }

  /** Two angles that are exchanged. */
  public record Swap(EulerAngle one, EulerAngle other) {
    /**
     * @throws IllegalArgumentException if they are the same
     */
    public Swap {
      if (one == other) {
        throw new IllegalArgumentException("an angle cannot be swapped with itself");
      }
    }

    /** Returns the source angles of yaw, pitch and roll, in this order. */
    public List<EulerAngle> order() {
      EulerAngle[] order = EulerAngle.values();
      order[one.ordinal()] = other;
      order[other.ordinal()] = one;
      return List.of(order);
    }
  }

  /**
   * The one-euro filter (Casiez, Roussel and Vogel, CHI 2012): a low-pass filter whose cutoff
   * frequency grows with speed, so that a head at rest does not jitter and a turning one does not
   * lag.
   *
   * @param cutoff cutoff frequency at rest, in Hz; lower is smoother
   * @param speed growth of the cutoff with speed, in Hz per radian per second; higher lags less
   */
  public record Smoothing(double cutoff, double speed) {
    /** Found empirically with 120 Hz and 0.1 degrees of noise; see docs/trackers.md. */
    public static final Smoothing DEFAULT = new Smoothing(1.5, 8);

    /**
     * @throws IllegalArgumentException if the cutoff is not positive or the speed negative
     */
    public Smoothing {
      if (!(cutoff > 0 && cutoff < 1e6 && speed >= 0 && speed < 1e6)) {
        throw new IllegalArgumentException(
            "smoothing needs a cutoff above 0 Hz and a speed of at least 0");
      }
    }

    /**
     * Reads {@code HZ} or {@code HZ,SPEED}, or {@code default}.
     *
     * @throws IllegalArgumentException with a message for the user if it is none of these
     */
    public static Smoothing parse(String text) {
      if (text.equals("default")) {
        return DEFAULT;
      }
      String[] numbers = text.split(",", -1);
      try {
        double cutoff = Double.parseDouble(numbers[0]);
        if (numbers.length <= 2) {
          return new Smoothing(
              cutoff, numbers.length == 2 ? Double.parseDouble(numbers[1]) : DEFAULT.speed());
        }
      } catch (NumberFormatException e) {
        // Reported below.
      }
      throw new IllegalArgumentException(
          "write smoothing as HZ or HZ,SPEED, such as 1.5,8, not as " + text);
    }
  }
}
