/**
 * Results formatted after the Publication Manual of the American Psychological Association (7th
 * edition, 2020, chapters 6 and 7), to paste into a manuscript: sentences, tables as HTML, LaTeX
 * and CSV, and the paragraph on methods with its references.
 *
 * <p>In: {@link org.selectiverenderer.statistics.study.StudyAnalysis}. Out: texts. Every mean comes
 * with its n; a value that is not defined is a dash. Uses {@code statistics.study}, {@code
 * statistics.anova}, {@code statistics.detection}, {@code formats.csv} and {@code base.markup}.
 */
@NullMarked
package org.selectiverenderer.statistics.apa;

import org.jspecify.annotations.NullMarked;
