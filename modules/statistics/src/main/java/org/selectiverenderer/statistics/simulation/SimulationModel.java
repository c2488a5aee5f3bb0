package org.selectiverenderer.statistics.simulation;

import java.util.List;

/**
 * The model of simulated participants: the equal-variance model of signal detection (Macmillan and
 * Creelman 2005, chapter 1).
 *
 * @param conditions names of the conditions, to which participants are assigned in turn
 * @param sensitivities mean d' of each condition
 * @param criteria mean c of each condition
 * @param sensitivitySpread standard deviation of d' between participants
 * @param criterionSpread standard deviation of c between participants
 * @param typeSensitivity added to d' for inconsistent objects
 * @param typeCriterion added to c for inconsistent objects; the thesis found a bias towards "no"
 * @param lists the recognition lists
 */
public record SimulationModel(
    List<String> conditions,
    List<Double> sensitivities,
    List<Double> criteria,
    double sensitivitySpread,
    double criterionSpread,
    double typeSensitivity,
    double typeCriterion,
    List<RecognitionListSpec> lists) {
  /** Checks that each condition has a d' and a c. */
  public SimulationModel {
    conditions = List.copyOf(conditions);
    sensitivities = List.copyOf(sensitivities);
    criteria = List.copyOf(criteria);
    lists = List.copyOf(lists);
    if (conditions.isEmpty()
        || sensitivities.size() != conditions.size()
        || criteria.size() != conditions.size()) {
      throw new IllegalArgumentException("each condition needs a d' and a c");
    }
  }

  /** Returns the areas of the recognition lists. */
  public List<String> areas() {
    return lists.stream().map(RecognitionListSpec::area).distinct().toList();
  }

  /** Returns the model with the recognition lists of one area only. */
  public SimulationModel of(String area) {
    return new SimulationModel(
        conditions,
        sensitivities,
        criteria,
        sensitivitySpread,
        criterionSpread,
        typeSensitivity,
        typeCriterion,
        lists.stream().filter(list -> list.area().equals(area)).toList());
  }
}
