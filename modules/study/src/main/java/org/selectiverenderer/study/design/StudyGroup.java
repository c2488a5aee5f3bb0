package org.selectiverenderer.study.design;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.selectiverenderer.schema.Condition;

/**
 * A group of participants: a combination of the levels of the between factors.
 *
 * @param name as {@code participants.tsv} has it: the names of the levels, with a plus between them
 * @param levels the names of the levels by the names of the factors, in the order of the factors
 * @param settings what all trials of the group show, unless something more special says otherwise
 */
public record StudyGroup(String name, Map<String, String> levels, TrialSettings settings) {
  /** Name of the single group of a study without between factors. */
  public static final String ALL = "all";

  /** Factor of a study that has conditions and no factors. */
  public static final String CONDITION = "condition";

  /** Returns the group of a condition, in a study without factors. */
  public static StudyGroup of(Condition condition) {
    return new StudyGroup(
        condition.spelling(), Map.of(CONDITION, condition.spelling()), TrialSettings.of(condition));
  }

  /**
   * Returns the groups of the between factors among {@code factors}, in the order of the levels.
   */
  public static List<StudyGroup> of(List<Factor> factors) {
    List<StudyGroup> groups = List.of(new StudyGroup("", Map.of(), TrialSettings.NONE));
    for (Factor factor : factors) {
      if (factor.scope() == Factor.Scope.BETWEEN) {
        List<StudyGroup> more = new ArrayList<>();
        for (StudyGroup group : groups) {
          factor.levels().forEach(level -> more.add(group.with(factor, level)));
        }
        groups = more;
      }
    }
    return groups.size() == 1
        ? List.of(new StudyGroup(ALL, Map.of(), TrialSettings.NONE))
        : List.copyOf(groups);
  }

  /** Returns the condition in which areas are shown to the group. */
  public Condition condition() {
    return settings.condition().orElse(Condition.HIGH);
  }

  private StudyGroup with(Factor factor, Factor.Level level) {
    Map<String, String> more = new LinkedHashMap<>(levels);
    more.put(factor.name(), level.name());
    return new StudyGroup(
        name.isEmpty() ? level.name() : name + "+" + level.name(),
        more,
        level.settings().over(settings));
  }
}
