package org.selectiverenderer.statistics.anova;

import java.util.List;
import java.util.Optional;
import org.selectiverenderer.base.decimal.Counted;

/**
 * What was measured on whom: each subject belongs to one level of the between factor and was
 * measured once at every level of the within factor. With one level of either it is a one-way or a
 * repeated-measures design.
 *
 * @param measure the dependent variable's name
 * @param subjects of any number per group
 */
public record Design(String measure, Factor within, Factor between, List<Subject> subjects) {
  public Design {
    subjects = List.copyOf(subjects);
    for (Subject subject : subjects) {
      if (subject.values().size() != within.levels().size()
          || subject.group() < 0
          || subject.group() >= between.levels().size()
          || !subject.values().stream().allMatch(Double::isFinite)) {
        throw new IllegalArgumentException("subject " + subject.id() + " does not fit the design");
      }
    }
  }

  /** The subjects of a level of the between factor. */
  public List<Subject> group(int level) {
    return subjects.stream().filter(subject -> subject.group() == level).toList();
  }

  /** Why these data cannot be analysed, empty when they can: a sentence without its full stop. */
  public Optional<String> obstacle() {
    int groups = between.levels().size();
    int values = within.levels().size();
    for (int level = 0; level < groups; level++) {
      if (group(level).isEmpty()) {
        return Optional.of(
            "there is no participant with complete data in the group "
                + between.levels().get(level));
      }
    }
    if (groups < 2 && values < 2) {
      return Optional.of(
          "there is one group and one level of " + within.name() + " only: nothing to compare");
    }
    return subjects.size() <= groups
        ? Optional.of(
            "%s in %s %s no degrees of freedom for the error"
                .formatted(
                    Counted.of(subjects.size(), "participant"),
                    Counted.of(groups, "group"),
                    subjects.size() == 1 ? "leaves" : "leave"))
        : Optional.empty();
  }
}
