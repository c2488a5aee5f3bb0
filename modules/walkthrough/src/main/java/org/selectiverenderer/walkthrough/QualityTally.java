package org.selectiverenderer.walkthrough;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.schema.Quality;
import org.selectiverenderer.walkthrough.timeline.QualityLevels;

/** Sums over the frames of a walkthrough how long its fields had which levels. */
final class QualityTally {
  private final SelectiveController controller;
  private final Map<Quality, Map<Integer, Double>> seconds = new EnumMap<>(Quality.class);
  private Map<Quality, Map<Integer, Integer>> now = Map.of();
  private long version = -1;
  private double since;

  QualityTally(SelectiveController controller) {
    this.controller = controller;
  }

  /**
   * Notes the levels that a frame shows.
   *
   * @param time seconds since the start of the walkthrough
   */
  void stepped(double time) {
    long present = controller.levelsVersion();
    if (present != version) {
      add(time);
      version = present;
      now = controller.levels();
    }
  }

  private void add(double time) {
    double passed = time - since;
    since = time;
    now.forEach(
        (quality, counts) ->
            counts.forEach(
                (level, count) ->
                    seconds
                        .computeIfAbsent(quality, key -> new TreeMap<>())
                        .merge(level, count * passed, Double::sum)));
  }

  /** Returns the sums until a time. */
  List<QualityLevels> until(double time) {
    add(time);
    List<QualityLevels> all = new ArrayList<>();
    for (Quality quality : Quality.values()) {
      Map<Integer, Double> lasted = seconds.getOrDefault(quality, Map.of());
      Map<Integer, Integer> counts = now.getOrDefault(quality, Map.of());
      Set<Integer> numbers = new TreeSet<>(lasted.keySet());
      numbers.addAll(counts.keySet());
      if (!numbers.isEmpty()) {
        all.add(
            new QualityLevels(
                quality,
                counts.values().stream().mapToInt(count -> count).sum(),
                numbers.stream()
                    .map(
                        level ->
                            new QualityLevels.Level(
                                level,
                                lasted.getOrDefault(level, 0.0),
                                counts.getOrDefault(level, 0)))
                    .toList()));
      }
    }
    return all;
  }
}
