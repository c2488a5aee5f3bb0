package org.selectiverenderer.experiment.threshold;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;

/**
 * One participant's trials: the tracks of all objects, mixed at random so that nobody can follow
 * one, and now and then a trial that only shows whether somebody attends. What comes next follows
 * from the study's seed, the participant, the number of the trial and the answers so far.
 */
public final class ThresholdPilot {
  private static final int NAMES = 4;

  private final ThresholdStudy study;
  private final String participant;
  private final Map<String, PilotTrack> tracks = new LinkedHashMap<>();
  private int answered;
  private int caught;
  private int catches;
  private String last = "";

  /**
   * Before the first trial.
   *
   * @param ladders of all objects of the study
   */
  public ThresholdPilot(
      ThresholdStudy study, Map<String, PolygonLadder> ladders, String participant) {
    this.study = study;
    this.participant = participant;
    for (ThresholdStudy.Judged judged : study.objects()) {
      PolygonLadder ladder = ladders.get(judged.object());
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

  /** The next trial, the same however often it is asked for; empty when all is found. */
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

  private PilotTrack track(String object) {
    PilotTrack track = tracks.get(object);
    if (track == null) {
      throw new IllegalArgumentException("no object " + object);
    }
    return track;
  }

  private Random random(int number) {
    long mixed = study.seed();
    for (char c : (participant + '/' + number).toCharArray()) {
      mixed = (mixed ^ c) * 0x100000001B3L; // FNV-1a, whose low bits Random then spreads.
    }
    return new Random(mixed * 0x9E3779B97F4A7C15L);
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
   * The participant has answered the next trial.
   *
   * @return whether that is right
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

  /** Objects whose threshold is still looked for. */
  public int left() {
    return open().size();
  }

  /** Whether an object's trials are over. */
  public boolean over(String object) {
    return track(object).over();
  }

  /** What an object's trials have come to. */
  public ThresholdEstimate estimate(String object) {
    return track(object).estimate();
  }

  /** Trials answered so far. */
  public int trials() {
    return answered;
  }

  /** Of those that only show whether somebody attends. */
  public int catches() {
    return catches;
  }

  /** Of these, the right ones. */
  public int caught() {
    return caught;
  }
}
