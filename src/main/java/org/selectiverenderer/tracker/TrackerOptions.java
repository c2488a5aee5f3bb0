package org.selectiverenderer.tracker;

import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * How the records of any tracker are read. They are applied in this order: swap, invert, smooth,
 * predict.
 *
 * @param swapped the two angles that change places; empty for none
 * @param inverted the angles whose sign is turned, after swapping
 * @param smoothing of trembling, at the cost of some delay; empty (the default) for none
 * @param prediction how far ahead of its record the pose is told, in seconds: the known time from
 *     the head's movement to the light of the display; 0 (the default) for none, at most 0.1
 */
public record TrackerOptions(
    Optional<Swap> swapped, Set<Axis> inverted, Optional<Smoothing> smoothing, double prediction) {
  /** More cannot be predicted of a head: it has stopped and turned back by then. */
  public static final double LONGEST_PREDICTION = 0.1;

  /** Records as they come. */
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

  /** Whether they change anything of a record. */
  public boolean change() {
    return swapped.isPresent() || !inverted.isEmpty() || smoothing.isPresent() || prediction > 0;
  }

  /** Two angles that change places. */
  public record Swap(Axis one, Axis other) {
    /**
     * @throws IllegalArgumentException if they are the same
     */
    public Swap {
      if (one == other) {
        throw new IllegalArgumentException("an angle cannot be swapped with itself");
      }
    }

    /** The angles by their places: yaw, pitch, roll of what is told come from these. */
    public List<Axis> order() {
      Axis[] order = Axis.values();
      order[one.ordinal()] = other;
      order[other.ordinal()] = one;
      return List.of(order);
    }
  }

  /**
   * The one-euro filter (Casiez, Roussel and Vogel, CHI 2012): a low-pass whose cutoff grows with
   * speed, so that a head at rest does not tremble and a turning one is not held back.
   *
   * @param cutoff at rest, in Hz; lower is calmer
   * @param speed by how much the cutoff grows, in Hz per radian per second; higher follows faster
   */
  public record Smoothing(double cutoff, double speed) {
    /** Found by trying with 120 Hz and 0.1 degrees of noise; see docs/trackers.md. */
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
     * @throws IllegalArgumentException with a sentence if it is neither
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
        // Said below.
      }
      throw new IllegalArgumentException(
          "write smoothing as HZ or HZ,SPEED, such as 1.5,8, not as " + text);
    }
  }
}
