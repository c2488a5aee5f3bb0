package org.selectiverenderer.statistics.anova;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.selectiverenderer.base.decimal.Pluralizer;

/**
 * The data of a factorial experiment. Each subject belongs to one combination of levels of the
 * between factors (a group) and was measured once at every combination of levels of the within
 * factors. Combinations are numbered with the last factor's level changing fastest.
 *
 * @param measure the dependent variable's name
 * @param withinFactors one or more; a design without within factors has one with one level
 * @param betweenFactors one or more; a design without between factors has one with one level
 * @param covariates names of variables measured once on each subject, whose influence is held
 *     constant
 * @param subjects all subjects; groups may differ in size
 */
public record FactorialDesign(
    String measure,
    List<Factor> withinFactors,
    List<Factor> betweenFactors,
    List<String> covariates,
    List<Subject> subjects) {
  /** Checks that the values of each subject are finite and fit the factors. */
  public FactorialDesign {
    withinFactors = List.copyOf(withinFactors);
    betweenFactors = List.copyOf(betweenFactors);
    covariates = List.copyOf(covariates);
    subjects = List.copyOf(subjects);
    int levels = Factor.crossed(withinFactors).levels().size();
    int groups = Factor.crossed(betweenFactors).levels().size();
    for (Subject subject : subjects) {
      if (subject.values().size() != levels
          || subject.group() < 0
          || subject.group() >= groups
          || subject.covariates().size() != covariates.size()
          || !Stream.concat(subject.values().stream(), subject.covariates().stream())
              .allMatch(Double::isFinite)) {
        throw new IllegalArgumentException("subject " + subject.id() + " does not fit the design");
      }
    }
  }

  /** A design with at most one factor of each sort and no covariate. */
  public FactorialDesign(String measure, Factor within, Factor between, List<Subject> subjects) {
    this(measure, List.of(within), List.of(between), List.of(), subjects);
  }

  /** Returns the within factors crossed to one factor. */
  public Factor within() {
    return Factor.crossed(withinFactors);
  }

  /** Returns the between factors crossed to one factor; its levels are the groups. */
  public Factor between() {
    return Factor.crossed(betweenFactors);
  }

  /** Returns the factors with two or more levels, within factors first. */
  public List<Factor> factors() {
    return Stream.concat(withinFactors.stream(), betweenFactors.stream())
        .filter(Factor::varies)
        .toList();
  }

  /** Returns the subjects of a group. */
  public List<Subject> group(int level) {
    return subjects.stream().filter(subject -> subject.group() == level).toList();
  }

  /**
   * Returns why these data cannot be analysed, as a sentence without its full stop; empty when they
   * can.
   */
  public Optional<String> obstacle() {
    Factor groups = between();
    for (int level = 0; level < groups.levels().size(); level++) {
      if (group(level).isEmpty()) {
        return Optional.of(
            "there is no participant with complete data in the group "
                + groups.levels().get(level));
      }
    }
    if (factors().isEmpty() && covariates.isEmpty()) {
      return Optional.of(
          "there is one group and one level of " + within().name() + " only: nothing to compare");
    }
    if (subjects.size() <= groups.levels().size() + covariates.size()) {
      return Optional.of(
          "%s in %s%s %s no degrees of freedom for the error"
              .formatted(
                  Pluralizer.of(subjects.size(), "participant"),
                  Pluralizer.of(groups.levels().size(), "group"),
                  covariates.isEmpty()
                      ? ""
                      : " with " + Pluralizer.of(covariates.size(), "covariate"),
                  subjects.size() == 1 ? "leaves" : "leave"));
    }
    return MultivariateLinearModel.redundantCovariate(this)
        .map(
            name ->
                "the covariate %s is redundant: the groups%s predict it exactly; leave it out"
                    .formatted(name, covariates.size() > 1 ? " and the other covariates" : ""));
  }
}
