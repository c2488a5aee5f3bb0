package org.selectiverenderer.experiment.study;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;

/**
 * What sets a session apart from the others, so that its answers may not count. A session's journal
 * says it; a study says which of them leave a session out.
 */
public enum SessionFlag {
  /** An exposure was begun again after it had been cut off: it may have been seen twice. */
  REPEATED_EXPOSURE("shown more than once"),
  /** Both eyes were shown in one window, as monitors or driver could not do what was asked for. */
  DISPLAY_FALLBACK("not shown on the display of the study"),
  /** There was no tracker, though the study has one. */
  TRACKER_ABSENT("without the study's tracker"),
  /** The tracker fell silent during an exposure for longer than the study allows. */
  TRACKER_LOST("tracker silent"),
  /** The headset was taken off, or its runtime was gone, during an exposure. */
  HEADSET_LOST("headset taken off or lost"),
  /** An exposure had fewer frames per second than the study asks for. */
  LOW_FRAME_RATE("too few frames per second"),
  /** The head log of a step lacks frames. */
  HEAD_LOG_INCOMPLETE("head log incomplete"),
  /** Exposures were shortened for a test. */
  SHORTENED("exposure shortened"),
  /** A simulated participant took part. */
  SIMULATED("simulated");

  private final String meaning;

  SessionFlag(String meaning) {
    this.meaning = meaning;
  }

  /** As journals and study files spell it. */
  public String spelling() {
    return name().toLowerCase(Locale.ROOT).replace('_', '-');
  }

  /** In a few words, for people. */
  public String meaning() {
    return meaning;
  }

  /** The flag of that spelling. */
  public static Optional<SessionFlag> of(String spelling) {
    return Arrays.stream(values()).filter(flag -> flag.spelling().equals(spelling)).findFirst();
  }
}
