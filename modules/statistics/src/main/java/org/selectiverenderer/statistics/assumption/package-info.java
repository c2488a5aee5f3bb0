/**
 * Checks of the assumptions of an analysis of variance, and what a violation implies: equal
 * variances (Levene's test, Brown and Forsythe's form), equal covariances (Box's M), normal
 * residuals (Shapiro and Wilk), no outliers (studentised residuals), and Welch's F, which does not
 * assume equal variances.
 *
 * <p>In: an {@link org.selectiverenderer.statistics.anova.Anova}. Out: {@link
 * org.selectiverenderer.statistics.assumption.AssumptionChecks}. Uses {@code statistics.anova},
 * {@code statistics.distribution} and Commons Math.
 */
@NullMarked
package org.selectiverenderer.statistics.assumption;

import org.jspecify.annotations.NullMarked;
