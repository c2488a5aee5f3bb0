package org.selectiverenderer.statistics.assumption;

import java.util.Optional;

/**
 * A score that its group's others do not lead to expect.
 *
 * @param participant whose it is
 * @param at the within level; empty when there is one only
 * @param studentised residual in standard errors, from the other scores
 * @param p times the number of scores at that level (Bonferroni)
 */
public record Outlier(
    String participant, Optional<String> at, double value, double studentised, double p) {}
