/**
 * Files of answers and of measurements, read into what the analyses take. Nothing is dropped in
 * silence: what cannot be used is a problem with its place, and an {@link
 * org.selectiverenderer.statistics.data.Exclusion} that reports print.
 *
 * <p>In: CSV files. Out: {@link org.selectiverenderer.statistics.data.Responses} and {@link
 * org.selectiverenderer.statistics.anova.Design}. Uses {@code statistics.detection}, {@code
 * statistics.anova}, {@code base.csv}, {@code base.files} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.statistics.data;

import org.jspecify.annotations.NullMarked;
