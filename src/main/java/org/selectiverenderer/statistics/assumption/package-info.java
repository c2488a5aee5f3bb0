/**
 * What an analysis of variance takes for granted, checked, and what follows from each check: equal
 * variances (Levene's test, Brown and Forsythe's form), equal covariances (Box's M), normal
 * residuals (Shapiro and Wilk), no outliers (studentised residuals), and Welch's F, which does
 * without equal variances.
 *
 * <p>In: an {@link org.selectiverenderer.statistics.anova.Anova}. Out: {@link
 * org.selectiverenderer.statistics.assumption.Assumptions}, of records and sentences. Uses {@code
 * statistics.anova}, {@code statistics.distribution} and Commons Math.
 */
@NullMarked
package org.selectiverenderer.statistics.assumption;

import org.jspecify.annotations.NullMarked;
