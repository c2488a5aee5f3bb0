package org.selectiverenderer.study.definition;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.Set;

/**
 * The quality criteria of a study: limits that raise a flag, and the flags that exclude a session
 * from the collected answers.
 *
 * @param minFps mean frames per second that an exposure must reach; empty for no limit
 * @param slowShare share of an exposure's frames, 0 to 1, that may take longer than a frame at
 *     {@code minFps}
 * @param trackerSilence seconds for which the tracker may send no records during an exposure
 * @param exclude flags by which {@code collect} excludes a session
 */
public record QualityCriteria(
    OptionalDouble minFps, double slowShare, double trackerSilence, Set<SessionFlag> exclude) {
  /**
   * The criteria of a study file without these keys: tracker silence of a second raises a flag, no
   * session is excluded.
   */
  public static final QualityCriteria DEFAULT =
      new QualityCriteria(OptionalDouble.empty(), 0.1, 1, Set.of());

  public QualityCriteria {
    exclude = exclude.isEmpty() ? Set.of() : Set.copyOf(EnumSet.copyOf(exclude));
  }

  /**
   * Returns the duration in milliseconds beyond which a frame is slow; infinite without a limit.
   */
  public double slowMs() {
    return minFps.isPresent() ? 1000 / minFps.getAsDouble() : Double.POSITIVE_INFINITY;
  }

  /**
   * Returns why the frame rate of an exposure is too low, a line for each reason; empty if it is
   * not.
   *
   * @param fps mean frames per second
   * @param slow share of frames that took longer than {@link #slowMs}
   */
  public List<String> tooSlow(double fps, double slow) {
    List<String> why = new ArrayList<>();
    if (minFps.isPresent() && fps < minFps.getAsDouble()) {
      why.add(
          String.format(
              Locale.ROOT,
              "%.1f frames per second on average, less than %s",
              fps,
              tidy(minFps.getAsDouble())));
    }
    if (minFps.isPresent() && slow > slowShare) {
      why.add(
          String.format(
              Locale.ROOT,
              "%.1f %% of the frames slower than %s per second, more than %s %%",
              100 * slow,
              tidy(minFps.getAsDouble()),
              tidy(100 * slowShare)));
    }
    return why;
  }

  private static String tidy(double number) {
    return number == Math.rint(number)
        ? Long.toString((long) number)
        : String.format(Locale.ROOT, "%.1f", number);
  }
}
