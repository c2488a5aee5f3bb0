package org.selectiverenderer.study.design;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import org.selectiverenderer.study.design.BlockProgress.StaircaseEstimate;
import org.selectiverenderer.study.design.TrialBlock.TrialStaircase;
import org.selectiverenderer.study.random.SeededRandom;

/**
 * The trials of a block with a staircase: one staircase for each combination of the other factors
 * and stimuli, interleaved at random so that the participant cannot follow one.
 */
final class StaircaseTrials {
  private final Factor varied;
  private final TrialSequencer sequencer;
  private final long seed;
  private final String participant;
  private final List<Track> tracks = new ArrayList<>();
  private int last = -1;
  private int current = -1;

  private record Track(TrialSequencer.Cell cell, UpDownStaircase staircase) {}

  StaircaseTrials(
      TrialBlock block,
      TrialStaircase rule,
      TrialSequencer sequencer,
      int turn,
      long seed,
      String participant) {
    this.sequencer = sequencer;
    this.seed = seed;
    this.participant = participant;
    varied =
        block.factors().stream()
            .filter(factor -> factor.name().equals(rule.factor()))
            .findFirst()
            .orElseThrow(() -> new IllegalArgumentException("no factor " + rule.factor()));
    for (TrialSequencer.Cell cell : sequencer.cellsWithout(varied, turn)) {
      tracks.add(
          new Track(
              cell,
              new UpDownStaircase(
                  varied.levels().size(),
                  rule.down(),
                  rule.reversals(),
                  rule.discarded(),
                  rule.most())));
    }
  }

  /** Returns the next trial, the same at every call until it is answered. */
  Optional<Trial> next(int number) {
    List<Integer> open = open();
    if (open.isEmpty()) {
      return Optional.empty();
    }
    if (open.size() > 1) {
      open.remove((Integer) last);
    }
    current = open.get(random(number).nextInt(open.size()));
    Track track = tracks.get(current);
    Map<String, String> levels = new LinkedHashMap<>(track.cell().levels());
    levels.put(varied.name(), varied.levels().get(track.staircase().level()).name());
    return Optional.of(
        sequencer.trial(new TrialSequencer.Cell(levels, track.cell().stimulus()), number, 1));
  }

  private List<Integer> open() {
    List<Integer> open = new ArrayList<>();
    for (int at = 0; at < tracks.size(); at++) {
      if (!tracks.get(at).staircase().over()) {
        open.add(at);
      }
    }
    return open;
  }

  private Random random(int number) {
    return SeededRandom.of(seed, participant + '/' + number);
  }

  /** Records the response to the trial that {@link #next} returned last. */
  void answered(boolean correct) {
    tracks.get(current).staircase().answered(correct);
    last = current;
  }

  boolean over() {
    return open().isEmpty();
  }

  List<StaircaseEstimate> estimates() {
    return tracks.stream().map(this::estimate).toList();
  }

  private StaircaseEstimate estimate(Track track) {
    return new StaircaseEstimate(
        track.cell().levels(),
        track.cell().stimulus().map(StimulusList.Stimulus::line).orElse(0),
        track.staircase().threshold().orElse(Double.NaN),
        track.staircase().counting().stream()
            .mapToDouble(level -> number(varied.levels().get(level).name()))
            .average()
            .orElse(Double.NaN),
        track.staircase().trials());
  }

  private static double number(String name) {
    try {
      return Double.parseDouble(name);
    } catch (NumberFormatException e) {
      return Double.NaN; // The estimate then has the mean level alone.
    }
  }
}
