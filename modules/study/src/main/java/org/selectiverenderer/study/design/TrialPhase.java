package org.selectiverenderer.study.design;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * A phase of a trial. Texts are in the participant's language; {@code {column}} stands for a cell
 * of the trial's stimulus, {@code {factor}} for the name of its level.
 */
public sealed interface TrialPhase {
  /** The longest duration of a phase in seconds: a working day. */
  double LONGEST = 36_000;

  /** Returns the phase with the texts of a trial in place of {@code {column}}. */
  TrialPhase filled(Trial trial);

  /**
   * A text that is read on a black picture until the participant goes on.
   *
   * @param audio a sound file that is played meanwhile
   */
  record Instruction(String text, Optional<Path> audio) implements TrialPhase {
    /** Makes an instruction without audio. */
    public Instruction(String text) {
      this(text, Optional.empty());
    }

    @Override
    public TrialPhase filled(Trial trial) {
      return new Instruction(trial.filled(text), audio);
    }
  }

  /**
   * A cross in the middle of a black picture.
   *
   * @param seconds at least 0
   */
  record Fixation(double seconds) implements TrialPhase {
    @Override
    public TrialPhase filled(Trial trial) {
      return this;
    }
  }

  /**
   * A black picture.
   *
   * @param seconds its duration; empty until one of the keys is pressed
   * @param response the keys that are a response to the trial
   */
  record Blank(OptionalDouble seconds, ResponseKeys response) implements TrialPhase {
    @Override
    public TrialPhase filled(Trial trial) {
      return this;
    }
  }

  /**
   * The scene.
   *
   * @param seconds its duration; empty for that of the trial's settings, which may be unlimited
   *     where a key or the scene ends the exposure
   * @param choices the {@code whichChoice} of Switches by DEF from the begin of this exposure to
   *     that of the next; values of {@code {column}} are numbers of the stimulus's cells
   * @param response the keys that are a response to the trial, and end the exposure
   * @param sceneEnds whether an event of the scene ends the exposure
   */
  record Exposure(
      OptionalDouble seconds, Map<String, String> choices, ResponseKeys response, boolean sceneEnds)
      implements TrialPhase {
    public Exposure {
      choices = Map.copyOf(choices);
    }

    @Override
    public TrialPhase filled(Trial trial) {
      Map<String, String> filled = new LinkedHashMap<>();
      choices.forEach((name, choice) -> filled.put(trial.filled(name), trial.filled(choice)));
      return new Exposure(seconds, filled, response, sceneEnds);
    }
  }

  /** The pages of a questionnaire, by its name in the study. */
  record Questions(String questionnaire) implements TrialPhase {
    @Override
    public TrialPhase filled(Trial trial) {
      return this;
    }
  }

  /**
   * A text that depends on whether the response was correct.
   *
   * @param missing the text where there was no response
   */
  record Feedback(String correct, String wrong, String missing, double seconds)
      implements TrialPhase {
    @Override
    public TrialPhase filled(Trial trial) {
      return new Feedback(
          trial.filled(correct), trial.filled(wrong), trial.filled(missing), seconds);
    }
  }

  /**
   * Phases that are repeated until there is a response.
   *
   * @param most number of rounds after which the trial goes on without a response
   */
  record Repeat(List<TrialPhase> phases, int most) implements TrialPhase {
    public Repeat {
      phases = List.copyOf(phases);
    }

    @Override
    public TrialPhase filled(Trial trial) {
      return new Repeat(phases.stream().map(phase -> phase.filled(trial)).toList(), most);
    }
  }

  /**
   * The keys of a response.
   *
   * @param keys names of keys: letters, digits, {@code space}, {@code left} ...; none for no
   *     response
   * @param correct the key of a correct response, perhaps {@code {column}}; empty where no response
   *     is wrong
   */
  record ResponseKeys(List<String> keys, String correct) {
    /** No response. */
    public static final ResponseKeys NONE = new ResponseKeys(List.of(), "");

    public ResponseKeys {
      keys = List.copyOf(keys);
    }
  }
}
