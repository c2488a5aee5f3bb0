package org.selectiverenderer.study.design;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.ToDoubleFunction;
import org.selectiverenderer.study.design.TrialPhase.ResponseKeys;

/**
 * The course of a trial through its phases, frame by frame. A phase begins with the first frame
 * that shows it and ends with the frame whose time is nearest to its planned end. The trial has one
 * response, the first: it ends the phase, or the repetition in which it falls, and later phases
 * with keys are passed over. Times are seconds of one clock that does not run in pauses. Belongs to
 * one thread.
 */
public final class TrialCourse {
  private final Trial trial;
  private final ToDoubleFunction<TrialPhase.Exposure> seconds;
  private final Listener listener;
  private final Deque<Position> positions = new ArrayDeque<>();
  private Optional<TrialPhase> current = Optional.empty();
  private boolean begun;
  private double start = Double.NaN;
  private double last = Double.NaN;
  private double asked = Double.NaN;
  private String response = "";
  private OptionalDouble responded = OptionalDouble.empty();
  private String correct = "";
  private boolean goOn;

  /** A place in a list of phases, with the rounds that are left of it. */
  private static final class Position {
    private final List<TrialPhase> phases;
    private final boolean repeats;
    private int rounds;
    private int at;

    Position(List<TrialPhase> phases, boolean repeats, int rounds) {
      this.phases = phases;
      this.repeats = repeats;
      this.rounds = rounds;
    }
  }

  /** Receives what happens, on the caller's thread. */
  public interface Listener {
    /** A phase begins with the frame of this time. */
    void began(TrialPhase phase, double time);

    /** A phase ends with the frame of this time, which does not show it any more. */
    void ended(TrialPhase phase, double began, double time);

    /** The participant responds, on the thread that hands the key over. */
    default void responded() {
      // Most listeners read the response when the trial is over.
    }
  }

  /**
   * @param seconds the durations of exposures; infinite where a key or the scene ends them
   */
  public TrialCourse(
      Trial trial, ToDoubleFunction<TrialPhase.Exposure> seconds, Listener listener) {
    this.trial = trial;
    this.seconds = seconds;
    this.listener = listener;
    positions.push(new Position(trial.phases(), false, 1));
  }

  /** Returns the phase that the present frame shows; empty before the first and after the last. */
  public Optional<TrialPhase> phase() {
    return current;
  }

  /** Returns whether the trial is over. */
  public boolean over() {
    return begun && current.isEmpty();
  }

  /**
   * Begins a frame: goes on to the next phase if the present one is over.
   *
   * @param time of the frame
   */
  public void frame(double time) {
    double interval = Double.isNaN(last) ? 0 : Math.max(0, time - last);
    last = time;
    if (!begun) {
      begun = true;
      next(time);
    }
    while (current.isPresent() && ended(current.get(), time, interval)) {
      listener.ended(current.get(), start, time);
      next(time);
    }
  }

  private boolean ended(TrialPhase phase, double time, double interval) {
    if (goOn) {
      return true;
    }
    // A phase of no time is passed over; any other is shown for a frame at least.
    double planned = planned(phase);
    return planned <= 0 || time > start && time - start >= planned - interval / 2;
  }

  private double planned(TrialPhase phase) {
    if (phase instanceof TrialPhase.Exposure exposure) {
      return seconds.applyAsDouble(exposure);
    } else if (phase instanceof TrialPhase.Fixation fixation) {
      return fixation.seconds();
    } else if (phase instanceof TrialPhase.Blank blank) {
      return blank.seconds().orElse(Double.POSITIVE_INFINITY);
    } else if (phase instanceof TrialPhase.Feedback feedback) {
      return feedback.seconds();
    }
    return Double.POSITIVE_INFINITY;
  }

  private void next(double time) {
    goOn = false;
    current = Optional.empty();
    while (!positions.isEmpty()) {
      Position position = positions.peek();
      if (position.at >= position.phases.size()) {
        if (--position.rounds > 0 && !answered()) {
          position.at = 0;
        } else {
          positions.pop();
        }
        continue;
      }
      TrialPhase phase = position.phases.get(position.at++);
      if (phase instanceof TrialPhase.Repeat repeat) {
        positions.push(new Position(repeat.phases(), true, repeat.most()));
      } else if (!answered() || keys(phase).keys().isEmpty()) {
        current = Optional.of(phase);
        begin(phase, time);
        return;
      }
    }
  }

  private void begin(TrialPhase phase, double time) {
    start = time;
    ResponseKeys keys = keys(phase);
    if (!keys.keys().isEmpty() && Double.isNaN(asked)) {
      asked = time;
    }
    if (correct.isEmpty() && !keys.correct().isEmpty()) {
      correct = trial.filled(keys.correct());
    }
    listener.began(phase, time);
  }

  private static ResponseKeys keys(TrialPhase phase) {
    return phase instanceof TrialPhase.Exposure exposure
        ? exposure.response()
        : phase instanceof TrialPhase.Blank blank ? blank.response() : ResponseKeys.NONE;
  }

  /** Returns the keys that are a response now; none where there is nothing to respond to. */
  public List<String> keys() {
    return answered() ? List.of() : current.map(phase -> keys(phase).keys()).orElse(List.of());
  }

  /** Returns the key of a correct response; empty before keys count, or where none is wrong. */
  public String correctKey() {
    return correct;
  }

  private boolean answered() {
    return responded.isPresent();
  }

  /**
   * Reports a key.
   *
   * @param key its name, as {@link ResponseKeys} has it
   * @param time when it went down
   * @return whether it means something now
   */
  public boolean key(String key, double time) {
    if (current.isPresent() && current.get() instanceof TrialPhase.Instruction) {
      boolean on = key.equals("space") || key.equals("enter");
      goOn |= on;
      return on;
    }
    if (!keys().contains(key)) {
      return false;
    }
    listener.responded();
    response = key;
    responded = OptionalDouble.of(Math.max(0, time - asked));
    goOn = true;
    if (positions.peek() != null && positions.peek().repeats) {
      positions.pop();
    }
    return true;
  }

  /** Ends an exposure that the scene may end. */
  public void sceneEnds() {
    goOn |=
        current.isPresent()
            && current.get() instanceof TrialPhase.Exposure exposure
            && exposure.sceneEnds();
  }

  /** Ends the questions that are asked. */
  public void questionsAnswered() {
    goOn |= current.isPresent() && current.get() instanceof TrialPhase.Questions;
  }

  /** Returns whether the response is correct; empty where none is wrong. */
  public Optional<Boolean> correct() {
    return correct.isEmpty() ? Optional.empty() : Optional.of(response.equals(correct));
  }

  /** Returns the text of feedback for the response, or for its lack. */
  public String feedback(TrialPhase.Feedback feedback) {
    if (!answered()) {
      return feedback.missing().isEmpty() ? feedback.wrong() : feedback.missing();
    }
    return correct().orElse(true) ? feedback.correct() : feedback.wrong();
  }

  /** Returns the result so far. */
  public TrialResult result() {
    OptionalDouble milliseconds =
        responded.isPresent()
            ? OptionalDouble.of(responded.getAsDouble() * 1000)
            : OptionalDouble.empty();
    return TrialResult.of(trial, response, milliseconds, correct());
  }
}
