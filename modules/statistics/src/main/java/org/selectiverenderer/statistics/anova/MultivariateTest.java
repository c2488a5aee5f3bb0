package org.selectiverenderer.statistics.anova;

/**
 * A multivariate test of an effect on the contrasts between within levels, which assumes no
 * sphericity.
 *
 * @param df1 degrees of freedom of the effect
 * @param df2 degrees of freedom of the error
 * @param exact whether F is F-distributed exactly (SPSS's footnote "Exact statistic"); Roy's F is
 *     an upper bound otherwise
 */
public record MultivariateTest(
    MultivariateStatistic statistic,
    double value,
    double f,
    double df1,
    double df2,
    double p,
    boolean exact) {}
