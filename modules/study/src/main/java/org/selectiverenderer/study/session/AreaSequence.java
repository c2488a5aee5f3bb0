package org.selectiverenderer.study.session;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.selectiverenderer.study.definition.Study;

/**
 * Determines the order in which a participant sees the areas; it is always the same for the same
 * study and participant.
 *
 * <p>Counterbalanced orders are the rows of Williams's squares (E. J. Williams 1949, "Experimental
 * designs balanced for the estimation of residual effects of treatments", Australian Journal of
 * Scientific Research A 2): Latin squares balanced for first-order carry-over, in which each area
 * also comes equally often right after each other area; an odd number of areas takes two squares,
 * of which the second is the mirror image of the first.
 */
final class AreaSequence {
  private AreaSequence() {}

  /**
   * Returns a participant's order.
   *
   * @param turn the participant's index among the places of the same condition, from 0
   */
  static List<Study.Area> of(Study study, String participant, int turn) {
    List<Study.Area> areas = new ArrayList<>(study.areas());
    switch (study.course().order()) {
      case COUNTERBALANCED -> {
        return areas.isEmpty()
            ? areas
            : row(areas.size(), turn).stream().map(study.areas()::get).toList();
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

  /** Returns a row of the Williams squares of a size, as numbers from 0. */
  static List<Integer> row(int size, int turn) {
    int rows = size % 2 == 0 ? size : 2 * size;
    int row = turn % rows;
    // The first row goes 0, 1, n-1, 2, n-2 ...; each other is that one, counted on.
    List<Integer> order =
        new ArrayList<>(
            IntStream.range(0, size)
                .map(at -> at % 2 == 1 ? (at + 1) / 2 : (size - at / 2) % size)
                .map(first -> (first + row) % size)
                .boxed()
                .toList());
    if (row >= size) {
      Collections.reverse(order);
    }
    return order;
  }

  /**
   * Returns how many places before a place have the same condition.
   *
   * @param place from 1
   */
  static int turn(Study study, int place) {
    RandomizationSchedule schedule = new RandomizationSchedule(study);
    return (int)
        IntStream.range(1, place)
            .filter(before -> schedule.condition(before) == schedule.condition(place))
            .count();
  }
}
