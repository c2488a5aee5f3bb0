package org.selectiverenderer.study.session;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.stream.IntStream;
import org.selectiverenderer.study.definition.Study;
import org.selectiverenderer.study.design.StudyGroup;

/**
 * The randomization schedule of a study: the group of each place. Places come in blocks that
 * contain every group equally often; the order within a block is random, by the study's seed and
 * the block's number. So a study always has the same schedule, and the groups are balanced after
 * each block.
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

  /** Returns the group of a place, counted from 1. */
  StudyGroup group(int place) {
    int number = (place - 1) / study.block();
    int within = (place - 1) % study.block();
    return switch (study.assignment()) {
      case BLOCKED -> block(number).get(within);
      case LATIN_SQUARE -> square(number / study.block(), number % study.block(), within);
    };
  }

  private List<StudyGroup> block(int number) {
    List<StudyGroup> block = new ArrayList<>();
    while (block.size() < study.block()) {
      block.addAll(study.design().groups());
    }
    Collections.shuffle(block, random(number));
    return block;
  }

  /**
   * Returns a cell of a Latin square, which has as many rows (blocks) and columns as there are
   * groups.
   */
  private StudyGroup square(int number, int row, int column) {
    int size = study.design().groups().size();
    Random random = random(number);
    List<Integer> rows = order(size, random);
    List<Integer> columns = order(size, random);
    List<Integer> letters = order(size, random);
    return study.design().groups().get(letters.get((rows.get(row) + columns.get(column)) % size));
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
   * Returns the first free place, of a group if one is wanted.
   *
   * @param taken the places that are taken
   */
  int free(Set<Integer> taken, Optional<StudyGroup> wanted) {
    int place = 1;
    while (taken.contains(place) || wanted.isPresent() && !group(place).equals(wanted.get())) {
      place++;
    }
    return place;
  }
}
