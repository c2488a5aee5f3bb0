/**
 * Writers of reports: text, JSON, SARIF, JUnit and GitHub annotations.
 *
 * <p>In: {@link org.selectiverenderer.validation.ValidationReport}. Out: text, the same on every
 * machine. Uses {@code validation}, {@code validation.run} for the rules, {@code x3d.source} and
 * {@code base}.
 */
@NullMarked
package org.selectiverenderer.validation.report;

import org.jspecify.annotations.NullMarked;
