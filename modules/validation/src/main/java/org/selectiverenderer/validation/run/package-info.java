/**
 * Runs the validator: finds the files, reads each once, runs the checks and collects their
 * findings.
 *
 * <p>In: files and folders, {@link org.selectiverenderer.validation.ValidationSettings}. Out: a
 * {@link org.selectiverenderer.validation.ValidationReport}. {@link
 * org.selectiverenderer.validation.run.Validator} is the entry point; {@link
 * org.selectiverenderer.validation.run.RuleCatalogue} depends on the packages of all groups of
 * rules, which do not depend on this package. Uses these, {@code validation}, {@code geometry},
 * {@code x3d} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.validation.run;

import org.jspecify.annotations.NullMarked;
