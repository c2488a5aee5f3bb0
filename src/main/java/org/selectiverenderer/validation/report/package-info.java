/**
 * Reports in the formats that people and CI systems read: text, JSON, SARIF, JUnit and GitHub's
 * annotations.
 *
 * <p>In: {@link org.selectiverenderer.validation.Report}. Out: characters, the same on every
 * machine. Uses {@code validation}, {@code validation.run} for the rules, {@code x3d.source} and
 * {@code base}.
 */
@NullMarked
package org.selectiverenderer.validation.report;

import org.jspecify.annotations.NullMarked;
