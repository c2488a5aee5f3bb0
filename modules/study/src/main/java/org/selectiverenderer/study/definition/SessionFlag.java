package org.selectiverenderer.study.definition;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;

/**
 * A quality flag of a session, whose answers then may not count. Flags are raised in the session's
 * journal; the study file lists those that exclude a session.
 */
public enum SessionFlag {
  /**
   * An exposure was repeated after an interruption: the participant may have seen the area twice.
   */
  REPEATED_EXPOSURE("shown more than once"),
  /**
   * Both eyes were shown in one window, as monitors or driver did not support the study's display.
   */
  DISPLAY_FALLBACK("not shown on the display of the study"),
  /** There was no tracker, though the study has one. */
  TRACKER_ABSENT("without the study's tracker"),
  /** The tracker sent no records during an exposure for longer than the study allows. */
  TRACKER_LOST("tracker silent"),
  /** A trigger signal could not be sent, as when its port had disappeared. */
  TRIGGER_FAILED("trigger signal not sent"),
  /**
   * The headset was taken off or left, or its runtime was lost, during an exposure.
   */
  HEADSET_LOST("headset taken off or lost"),
  /** In a browser, the page lost the focus or left the full screen during an exposure. */
  LEFT_PAGE("page left"),
  /** In a browser, an exposure was over before any of its pictures was seen. */
  NOT_SEEN("exposure not seen"),
  /** An exposure had fewer frames per second than the study asks for. */
  LOW_FRAME_RATE("too few frames per second"),
  /** A practice block ended without having reached its criterion. */
  PRACTICE_FAILED("practice not passed"),
  /** The head log of a step lacks frames. */
  HEAD_LOG_INCOMPLETE("head log incomplete"),
  /** The wall clock was set, or the computer slept, while the session ran. */
  CLOCK_MOVED("wall clock moved"),
  /** Exposures were shortened for a test. */
  SHORTENED("exposure shortened"),
  /** A simulated participant took part. */
  SIMULATED("simulated");

  private final String meaning;

  SessionFlag(String meaning) {
    this.meaning = meaning;
  }

  /** Returns the spelling in journals and study files. */
  public String spelling() {
    return name().toLowerCase(Locale.ROOT).replace('_', '-');
  }

  /** Returns the meaning in a few words, for people. */
  public String meaning() {
    return meaning;
  }

  /** Returns the flag with a spelling. */
  public static Optional<SessionFlag> of(String spelling) {
    return Arrays.stream(values()).filter(flag -> flag.spelling().equals(spelling)).findFirst();
  }
}
