/**
 * Reports of analyses: text, JSON, CSV (tidy and wide) and one self-contained HTML page.
 *
 * <p>In: {@link org.selectiverenderer.statistics.study.StudyAnalysis} or {@link
 * org.selectiverenderer.statistics.anova.Anova}. Out: texts; the same input gives the same bytes.
 * Text and HTML are two forms of one {@link org.selectiverenderer.statistics.report.ReportBlock}
 * tree. A value that is not defined is a dash with a footnote, in JSON null with its reason beside
 * it, in CSV an empty cell with the reason in the row. Uses the other packages of {@code
 * statistics}, {@code chart}, {@code geometry.font} and {@code base}.
 */
@NullMarked
package org.selectiverenderer.statistics.report;

import org.jspecify.annotations.NullMarked;
