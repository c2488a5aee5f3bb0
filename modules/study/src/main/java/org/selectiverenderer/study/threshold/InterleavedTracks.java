package org.selectiverenderer.study.threshold;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import org.selectiverenderer.study.random.SeededRandom;

/**
 * One participant's trials: the tracks of all objects, randomly interleaved so that the participant
 * cannot follow one, with occasional catch trials, which test attention. The next trial is
 * determined by the study's seed, the participant, the number of the trial and the answers so far.
 */
public final class InterleavedTracks {
  private static final int NAMES = 4;

  private final ThresholdStudy study;
  private final String participant;
  private final Map<String, AdaptiveTrack> tracks = new LinkedHashMap<>();
  private int answered;
  private int caught;
  private int catches;
  private String last = "";

  /**
   * Starts before the first trial.
   *
   * @param ladders the versions of all objects of the study
   */
  public InterleavedTracks(
      ThresholdStudy study, Map<String, StimulusLevels> ladders, String participant) {
    this.study = study;
    this.participant = participant;
    for (ThresholdStudy.Judged judged : study.objects()) {
      StimulusLevels ladder = ladders.get(judged.object());
      if (ladder == null) {
        throw new IllegalArgumentException("no versions of " + judged.object());
      }
      tracks.put(
          judged.object(),
          study.task() == ThresholdTask.TELL_APART
              ? new Staircase(study.rule(), ladder)
              : new AscendingSeries(ladder));
    }
  }

  /**
   * Returns the next trial, the same at every call until it is answered; empty after the last one.
   */
  public Optional<ThresholdTrial> next() {
    List<String> open = open();
    if (open.isEmpty()) {
      return Optional.empty();
    }
    if (open.size() > 1) {
      open.remove(last);
    }
    int number = answered + 1;
    Random random = random(number);
    String object = open.get(random.nextInt(open.size()));
    int rung = track(object).rung();
    int view = random.nextInt(study.views().size());
    if (study.task() == ThresholdTask.RECOGNISE) {
      return Optional.of(
          new ThresholdTrial(number, object, rung, view, "", names(object, random), object));
    }
    String catching = random.nextDouble() < study.catches() ? another(object, random) : "";
    return Optional.of(
        new ThresholdTrial(
            number,
            object,
            rung,
            view,
            catching,
            List.of(ThresholdTrial.LEFT, ThresholdTrial.RIGHT),
            random.nextBoolean() ? ThresholdTrial.LEFT : ThresholdTrial.RIGHT));
  }

  private AdaptiveTrack track(String object) {
    AdaptiveTrack track = tracks.get(object);
    if (track == null) {
      throw new IllegalArgumentException("no object " + object);
    }
    return track;
  }

  private Random random(int number) {
    return SeededRandom.of(study.seed(), participant + '/' + number);
  }

  private List<String> others(String object, Random random) {
    List<String> others = new ArrayList<>(tracks.keySet());
    others.remove(object);
    Collections.shuffle(others, random);
    return others;
  }

  private String another(String object, Random random) {
    return others(object, random).get(0);
  }

  private List<String> names(String object, Random random) {
    List<String> names = new ArrayList<>(others(object, random).subList(0, NAMES - 1));
    names.add(random.nextInt(NAMES), object);
    return names;
  }

  /**
   * Records the answer to the next trial.
   *
   * @return whether the answer is right
   */
  public boolean answered(ThresholdTrial trial, String response) {
    boolean correct = response.equals(trial.right());
    answered++;
    last = trial.object();
    if (trial.catches()) {
      catches++;
      caught += correct ? 1 : 0;
    } else {
      track(trial.object()).answered(correct);
    }
    return correct;
  }

  private List<String> open() {
    return new ArrayList<>(
        tracks.entrySet().stream()
            .filter(track -> !track.getValue().over())
            .map(Map.Entry::getKey)
            .toList());
  }

  /** Returns the number of objects whose track has not ended. */
  public int left() {
    return open().size();
  }

  /** Returns whether an object's track has ended. */
  public boolean over(String object) {
    return track(object).over();
  }

  /** Returns the estimate of an object's threshold. */
  public ThresholdEstimate estimate(String object) {
    return track(object).estimate();
  }

  /** Returns the number of trials answered so far. */
  public int trials() {
    return answered;
  }

  /** Returns the number of catch trials answered so far. */
  public int catches() {
    return catches;
  }

  /** Returns the number of catch trials answered right. */
  public int caught() {
    return caught;
  }
}
