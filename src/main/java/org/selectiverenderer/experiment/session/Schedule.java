package org.selectiverenderer.experiment.session;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import org.selectiverenderer.control.Condition;
import org.selectiverenderer.experiment.study.Study;

/**
 * Which condition whose turn brings: blocked randomisation. Places come in blocks that hold every
 * condition equally often, in an order drawn from the study's seed and the block's number; so the
 * same study has the same schedule always, and after each block the groups are balanced.
 */
final class Schedule {
  private final Study study;

  Schedule(Study study) {
    this.study = study;
  }

  /** The condition of a place, counted from 1. */
  Condition condition(int place) {
    List<Condition> block = new ArrayList<>();
    while (block.size() < study.block()) {
      block.addAll(study.conditions());
    }
    int number = (place - 1) / study.block();
    // The first draws of Random hardly differ for seeds close to each other.
    Collections.shuffle(block, new Random((study.seed() + 31L * number) * 0x9E3779B97F4A7C15L));
    return block.get((place - 1) % study.block());
  }

  /**
   * The first place that is free, of a condition where one is wanted.
   *
   * @param taken places
   */
  int free(Set<Integer> taken, Optional<Condition> wanted) {
    int place = 1;
    while (taken.contains(place) || wanted.isPresent() && condition(place) != wanted.get()) {
      place++;
    }
    return place;
  }
}
