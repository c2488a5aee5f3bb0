package org.selectiverenderer.statistics.assumption;

import java.util.Optional;

/**
 * A score that deviates significantly from the others of its group.
 *
 * @param participant the participant whose score it is
 * @param at the within level; empty when there is one only
 * @param studentised externally studentised residual
 * @param p Bonferroni-corrected p: multiplied by the number of scores at that level
 */
public record Outlier(
    String participant, Optional<String> at, double value, double studentised, double p) {}
