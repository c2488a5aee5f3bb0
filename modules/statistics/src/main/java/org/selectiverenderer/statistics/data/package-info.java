/**
 * Readers for files of answers and of measurements. Nothing is dropped silently: each row that
 * cannot be used is reported as a problem with its location, and as an {@link
 * org.selectiverenderer.statistics.data.Exclusion} that reports print.
 *
 * <p>In: CSV files. Out: {@link org.selectiverenderer.statistics.data.Responses} and {@link
 * org.selectiverenderer.statistics.anova.FactorialDesign}. Uses {@code statistics.detection},
 * {@code statistics.anova}, {@code formats.csv}, {@code base.files} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.statistics.data;

import org.jspecify.annotations.NullMarked;
