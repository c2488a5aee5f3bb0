package org.selectiverenderer.study.design;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import org.selectiverenderer.study.random.SeededRandom;

/**
 * Determines the trials of a participant in a block, in order. The same seed, group, place and
 * round always give the same trials.
 */
public final class TrialSequencer {
  /** Number of random orders that are tried before the limits of runs count as too tight. */
  private static final int ATTEMPTS = 500;

  private static final int MOST_FULL = 6;

  private final TrialBlock block;
  private final StudyGroup group;
  private final long seed;

  /** A trial without its place: a combination of levels and a stimulus. */
  record Cell(Map<String, String> levels, Optional<StimulusList.Stimulus> stimulus) {
    /** Returns the level of a factor, or the cell of a column. */
    String value(String name) {
      return levels.getOrDefault(
          name, stimulus.map(row -> row.cells().getOrDefault(name, "")).orElse(""));
    }
  }

  /**
   * @param seed random seed of the study
   */
  public TrialSequencer(TrialBlock block, StudyGroup group, long seed) {
    this.block = block;
    this.group = group;
    this.seed = seed;
  }

  /** Returns the most combinations of which all orders can be gone through. */
  public static int mostOfFullOrder() {
    return MOST_FULL;
  }

  /**
   * Returns the trials of a participant; empty if no order was found that keeps the block's limits
   * of runs.
   *
   * @param turn the participant's index among those of the group, from 0
   * @param round the round of a practice block, from 1
   */
  public Optional<List<Trial>> trials(int turn, int round) {
    List<Map<String, String>> combinations = combinations(block.crossed());
    Random random = random(turn, round);
    return switch (block.order()) {
      case FIXED -> Optional.of(numbered(cells(combinations, turn), round));
      case FULL ->
          Optional.of(
              numbered(
                  grouped(
                      combinations,
                      permutation(combinations.size(), turn),
                      pairing(turn, orders(combinations.size())),
                      random),
                  round));
      case LATIN_SQUARE ->
          Optional.of(
              numbered(
                  grouped(
                      combinations,
                      WilliamsSquare.row(combinations.size(), turn),
                      pairing(turn, WilliamsSquare.rows(combinations.size())),
                      random),
                  round));
      case RANDOM ->
          shuffled(cells(combinations, turn), random).map(cells -> numbered(cells, round));
    };
  }

  /**
   * Returns the shift by which stimuli are paired with combinations. It moves on with each
   * participant, and by one more when the orders begin anew: otherwise an order would always come
   * with the same pairing.
   */
  private static int pairing(int turn, int orders) {
    return turn + turn / orders;
  }

  private static int orders(int combinations) {
    int orders = 1;
    for (int i = 2; i <= combinations; i++) {
      orders *= i;
    }
    return orders;
  }

  /**
   * Returns the trials of an order that was recorded.
   *
   * @throws IllegalArgumentException if the list no longer has a row of it
   */
  List<Trial> rebuilt(List<TrialKey> keys, int round) {
    List<Cell> cells = new ArrayList<>();
    for (TrialKey key : keys) {
      Optional<StimulusList.Stimulus> stimulus =
          block
              .stimuli()
              .flatMap(
                  list -> list.rows().stream().filter(row -> row.line() == key.line()).findFirst());
      if (stimulus.isEmpty() && key.line() > 0) {
        throw new IllegalArgumentException(
            "the order of the trials that this participant has begun needs line %d of the stimuli of the block %s, which the list no longer has; put the list back as it was"
                .formatted(key.line(), block.name()));
      }
      cells.add(new Cell(key.levels(), stimulus));
    }
    return numbered(cells, round);
  }

  /** Returns all combinations of the levels of factors, the last factor varying fastest. */
  static List<Map<String, String>> combinations(List<Factor> factors) {
    List<Map<String, String>> all = List.of(Map.of());
    for (Factor factor : factors) {
      List<Map<String, String>> more = new ArrayList<>();
      for (Map<String, String> known : all) {
        for (Factor.Level level : factor.levels()) {
          Map<String, String> with = new LinkedHashMap<>(known);
          with.put(factor.name(), level.name());
          more.add(with);
        }
      }
      all = more;
    }
    return all;
  }

  /** Returns the cells of all crossed factors but one, each once, without their order. */
  List<Cell> cellsWithout(Factor varied, int turn) {
    List<Map<String, String>> combinations =
        combinations(block.crossed().stream().filter(factor -> !factor.equals(varied)).toList());
    List<Cell> cells = new ArrayList<>();
    for (int combination = 0; combination < combinations.size(); combination++) {
      cells.addAll(of(combinations, combination, turn));
    }
    return cells;
  }

  private List<Cell> cells(List<Map<String, String>> combinations, int turn) {
    List<Cell> cells = new ArrayList<>();
    for (int repetition = 0; repetition < block.repetitions(); repetition++) {
      for (int combination = 0; combination < combinations.size(); combination++) {
        cells.addAll(of(combinations, combination, turn));
      }
    }
    return cells;
  }

  /** Returns the cells of a combination, in the order of the stimuli. */
  private List<Cell> of(List<Map<String, String>> combinations, int combination, int shift) {
    Map<String, String> levels = combinations.get(combination);
    if (block.stimuli().isEmpty()) {
      return List.of(new Cell(levels, Optional.empty()));
    }
    List<Cell> cells = new ArrayList<>();
    List<StimulusList.Stimulus> rows = block.stimuli().get().rows();
    for (int row = 0; row < rows.size(); row++) {
      boolean paired =
          block.pairing() == TrialBlock.Pairing.CROSSED
              || (row + shift) % combinations.size() == combination;
      if (paired) {
        Map<String, String> all = new LinkedHashMap<>();
        for (Factor factor : block.factors()) {
          String own = rows.get(row).cells().get(factor.name());
          all.put(factor.name(), own == null ? levels.getOrDefault(factor.name(), "") : own);
        }
        cells.add(new Cell(all, Optional.of(rows.get(row))));
      }
    }
    return cells;
  }

  private List<Cell> grouped(
      List<Map<String, String>> combinations, List<Integer> order, int shift, Random random) {
    List<Cell> cells = new ArrayList<>();
    for (int combination : order) {
      List<Cell> together = new ArrayList<>();
      for (int repetition = 0; repetition < block.repetitions(); repetition++) {
        together.addAll(of(combinations, combination, shift));
      }
      Collections.shuffle(together, random);
      cells.addAll(together);
    }
    return cells;
  }

  /** Returns a permutation of 0 to size - 1 by its number in lexicographic order. */
  private static List<Integer> permutation(int size, int number) {
    List<Integer> left = new ArrayList<>();
    long count = 1;
    for (int i = 0; i < size; i++) {
      left.add(i);
      count *= i + 1;
    }
    long rest = number % count;
    List<Integer> order = new ArrayList<>();
    for (int place = size; place > 0; place--) {
      count /= place;
      order.add(left.remove((int) (rest / count)));
      rest %= count;
    }
    return order;
  }

  private Optional<List<Cell>> shuffled(List<Cell> cells, Random random) {
    for (int attempt = 0; attempt < ATTEMPTS; attempt++) {
      List<Cell> left = new ArrayList<>(cells);
      Collections.shuffle(left, random);
      List<Cell> order = new ArrayList<>();
      boolean stuck = false;
      while (!stuck && !left.isEmpty()) {
        stuck = true;
        for (int candidate = 0; candidate < left.size(); candidate++) {
          if (mayFollow(order, left.get(candidate))) {
            order.add(left.remove(candidate));
            stuck = false;
            break;
          }
        }
      }
      if (!stuck) {
        return Optional.of(order);
      }
    }
    return Optional.empty();
  }

  /** Returns whether a cell may come after others without making a run too long. */
  private boolean mayFollow(List<Cell> order, Cell next) {
    for (Map.Entry<String, Integer> limit : block.runs().entrySet()) {
      String value = next.value(limit.getKey());
      int run = 0;
      for (int at = order.size() - 1; at >= 0 && run < limit.getValue(); at--) {
        if (!order.get(at).value(limit.getKey()).equals(value)) {
          break;
        }
        run++;
      }
      if (run == limit.getValue()) {
        return false;
      }
    }
    return true;
  }

  private List<Trial> numbered(List<Cell> cells, int round) {
    List<Trial> trials = new ArrayList<>();
    for (Cell cell : cells) {
      trials.add(trial(cell, trials.size() + 1, round));
    }
    return List.copyOf(trials);
  }

  /**
   * Returns the trial of a recorded key at a place of its block.
   *
   * @param stimulus the cells of the row as they were then; empty without a list
   * @param ofRow what the row determines; what it does not is left to levels and block
   */
  public Trial recorded(
      TrialKey key, Map<String, String> stimulus, TrialSettings ofRow, int number, int round) {
    StimulusList.Stimulus row = new StimulusList.Stimulus(key.line(), stimulus, ofRow);
    return trial(new Cell(key.levels(), Optional.of(row)), number, round);
  }

  /** Returns the trial of a cell. */
  Trial trial(Cell cell, int number, int round) {
    TrialSettings settings = block.settings().over(group.settings());
    for (Factor factor : block.factors()) {
      settings =
          factor
              .level(cell.levels().getOrDefault(factor.name(), ""))
              .map(Factor.Level::settings)
              .orElse(TrialSettings.NONE)
              .over(settings);
    }
    settings =
        cell.stimulus()
            .map(StimulusList.Stimulus::settings)
            .orElse(TrialSettings.NONE)
            .over(settings);
    Map<String, String> levels = new LinkedHashMap<>(group.levels());
    levels.putAll(cell.levels());
    Trial bare =
        new Trial(
            block.name(),
            number,
            round,
            levels,
            cell.stimulus().map(StimulusList.Stimulus::cells).orElse(Map.of()),
            cell.stimulus().map(StimulusList.Stimulus::line).orElse(0),
            settings,
            List.of());
    return new Trial(
        block.name(),
        number,
        round,
        levels,
        bare.stimulus(),
        bare.line(),
        settings,
        block.phases().stream().map(phase -> phase.filled(bare)).toList());
  }

  private Random random(int turn, int round) {
    return SeededRandom.of(seed, block.name() + '/' + group.name() + '/' + turn + '/' + round);
  }
}
