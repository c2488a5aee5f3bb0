package org.selectiverenderer.study.definition;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * The trigger signals that sessions of a study send by a serial port, such as to an EEG amplifier.
 *
 * @param port name of the serial port, such as {@code COM3} or {@code /dev/ttyUSB0}
 * @param speed in baud
 * @param events the signals by the events at which they are sent, one of {@link #EVENTS}
 */
public record TriggerSettings(String port, int speed, Map<String, Signal> events) {
  /** Events of a trial, whose signals may be taken from a column of its stimulus. */
  public static final List<String> OF_TRIALS =
      List.of(
          "instruction-began",
          "fixation-began",
          "exposure-began",
          "blank-began",
          "feedback-began",
          "questions-began",
          "response",
          "step-began",
          "step-finished");

  /** All events at which signals can be sent. */
  public static final List<String> EVENTS = all();

  /** The wires of a serial port that a program can switch. */
  public enum Wire {
    RTS,
    DTR;

    /** Returns the spelling in the study file. */
    public String spelling() {
      return name().toLowerCase(Locale.ROOT);
    }
  }

  /** A signal. */
  public sealed interface Signal {
    /**
     * Returns for how many milliseconds the signal lasts; 0 for a byte that is not followed by
     * another.
     */
    double ms();
  }

  /**
   * A byte; after its duration, if any, a zero byte follows.
   *
   * @param code 1 to 255, or the name of a factor or a column of the stimuli in braces
   */
  public record Code(String code, double ms) implements Signal {}

  /** A wire that is switched on for the duration. */
  public record Line(Wire wire, double ms) implements Signal {}

  public TriggerSettings {
    events = Collections.unmodifiableMap(new LinkedHashMap<>(events));
  }

  private static List<String> all() {
    List<String> all = new ArrayList<>(OF_TRIALS);
    all.addAll(
        List.of(
            "shown",
            "answer",
            "page",
            "scene-event",
            "calibration",
            "paused",
            "continued",
            "go-on",
            "heading-reset",
            "note",
            "aborted",
            "session-finished"));
    return List.copyOf(all);
  }
}
