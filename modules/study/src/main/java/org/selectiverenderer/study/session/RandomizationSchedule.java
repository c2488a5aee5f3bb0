package org.selectiverenderer.study.session;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.stream.IntStream;
import org.selectiverenderer.schema.Condition;
import org.selectiverenderer.study.definition.Study;

/**
 * The randomization schedule of a study: the condition of each place. Places come in blocks that
 * contain every condition equally often; the order within a block is random, by the study's seed
 * and the block's number. So a study always has the same schedule, and the groups are balanced
 * after each block.
 *
 * <p>Permuted blocks: Zelen 1974, "The randomization and stratification of patients to clinical
 * trials". Latin squares drawn by permuting the rows, columns and letters of the cyclic one: Fisher
 * and Yates 1938, "Statistical Tables", introduction; Cochran and Cox 1957, "Experimental Designs",
 * 4.3.
 */
final class RandomizationSchedule {
  private final Study study;

  RandomizationSchedule(Study study) {
    this.study = study;
  }

  /** Returns the condition of a place, counted from 1. */
  Condition condition(int place) {
    int number = (place - 1) / study.block();
    int within = (place - 1) % study.block();
    return switch (study.assignment()) {
      case BLOCKED -> block(number).get(within);
      case LATIN_SQUARE -> square(number / study.block(), number % study.block(), within);
    };
  }

  private List<Condition> block(int number) {
    List<Condition> block = new ArrayList<>();
    while (block.size() < study.block()) {
      block.addAll(study.conditions());
    }
    Collections.shuffle(block, random(number));
    return block;
  }

  /**
   * Returns a cell of a Latin square, which has as many rows (blocks) and columns as there are
   * conditions.
   */
  private Condition square(int number, int row, int column) {
    int size = study.conditions().size();
    Random random = random(number);
    List<Integer> rows = order(size, random);
    List<Integer> columns = order(size, random);
    List<Integer> letters = order(size, random);
    return study.conditions().get(letters.get((rows.get(row) + columns.get(column)) % size));
  }

  private static List<Integer> order(int size, Random random) {
    List<Integer> order = new ArrayList<>(IntStream.range(0, size).boxed().toList());
    Collections.shuffle(order, random);
    return order;
  }

  private Random random(int number) {
    // The first draws of Random hardly differ for seeds close to each other.
    return new Random((study.seed() + 31L * number) * 0x9E3779B97F4A7C15L);
  }

  /**
   * Returns the first free place, of a condition if one is wanted.
   *
   * @param taken the places that are taken
   */
  int free(Set<Integer> taken, Optional<Condition> wanted) {
    int place = 1;
    while (taken.contains(place) || wanted.isPresent() && condition(place) != wanted.get()) {
      place++;
    }
    return place;
  }
}
