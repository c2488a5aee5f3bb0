/**
 * A study as tidy tables for R, JASP and pandas: one file for each level of analysis, each row with
 * the keys of the levels above it, and a codebook of every column.
 *
 * <p>In: a {@link org.selectiverenderer.study.dataset.RecordedStudy} and the answers that {@code
 * experiment collect} takes. Out: CSV files, {@code codebook.csv} and {@code codebook.json}, and
 * scripts for R and Python that read the tables with the types of the codebook.
 *
 * <p>{@link org.selectiverenderer.study.export.StudyExport} assembles the tables. Uses {@code
 * study.dataset}, {@code study.headlog} for what was looked at, and {@code base}.
 */
@NullMarked
package org.selectiverenderer.study.export;

import org.jspecify.annotations.NullMarked;
