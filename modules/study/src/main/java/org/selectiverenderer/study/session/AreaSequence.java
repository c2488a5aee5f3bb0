package org.selectiverenderer.study.session;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.selectiverenderer.study.definition.Study;
import org.selectiverenderer.study.design.WilliamsSquare;

/**
 * Determines the order in which a participant sees the areas; it is always the same for the same
 * study and participant.
 *
 * <p>Counterbalanced orders are the rows of Williams's squares ({@link WilliamsSquare}).
 */
final class AreaSequence {
  private AreaSequence() {}

  /**
   * Returns a participant's order.
   *
   * @param turn the participant's index among the places of the same group, from 0
   */
  static List<Study.Area> of(Study study, String participant, int turn) {
    List<Study.Area> areas = new ArrayList<>(study.areas());
    switch (study.course().order()) {
      case COUNTERBALANCED -> {
        return areas.isEmpty()
            ? areas
            : WilliamsSquare.row(areas.size(), turn).stream().map(study.areas()::get).toList();
      }
      case RANDOM ->
          // The first draws of Random hardly differ for seeds close to each other.
          Collections.shuffle(
              areas,
              new Random((study.seed() * 31 + participant.hashCode()) * 0x9E3779B97F4A7C15L));
      case FIXED -> {
        // The order in the study file.
      }
    }
    return areas;
  }

  /**
   * Returns how many places before a place have the same group.
   *
   * @param place from 1
   */
  static int turn(Study study, int place) {
    RandomizationSchedule schedule = new RandomizationSchedule(study);
    return (int)
        IntStream.range(1, place)
            .filter(before -> schedule.group(before).equals(schedule.group(place)))
            .count();
  }
}
