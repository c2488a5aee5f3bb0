package org.selectiverenderer.experiment.study;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.Set;

/**
 * What a study asks of its sessions, and which flags leave a session out of the collected answers.
 *
 * @param minFps frames per second that an exposure must have on average; empty for no matter
 * @param slowShare of an exposure's frames, 0 to 1, that may take longer than one at {@code minFps}
 * @param trackerSilence seconds for which the tracker may fall silent during an exposure
 * @param exclude flags by which {@code collect} leaves a session out
 */
public record StudyQuality(
    OptionalDouble minFps, double slowShare, double trackerSilence, Set<SessionFlag> exclude) {
  /** Of a study that says nothing: silence of a second is told, nothing is left out. */
  public static final StudyQuality DEFAULT =
      new StudyQuality(OptionalDouble.empty(), 0.1, 1, Set.of());

  public StudyQuality {
    exclude = exclude.isEmpty() ? Set.of() : Set.copyOf(EnumSet.copyOf(exclude));
  }

  /** Milliseconds beyond which a frame is slow; infinite where it does not matter. */
  public double slowMs() {
    return minFps.isPresent() ? 1000 / minFps.getAsDouble() : Double.POSITIVE_INFINITY;
  }

  /**
   * Why an exposure's frames are too few, in a line for people each; none where they are not.
   *
   * @param fps frames per second on average
   * @param slow share of the frames that took longer than {@link #slowMs}
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
