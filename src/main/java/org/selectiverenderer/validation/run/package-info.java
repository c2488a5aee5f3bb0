/**
 * A run of the validator: finds the files, reads each once, makes the checks, gathers what they
 * find.
 *
 * <p>In: files and folders, {@link org.selectiverenderer.validation.ValidationSettings}. Out: a
 * {@link org.selectiverenderer.validation.Report}. {@link
 * org.selectiverenderer.validation.run.Validator} is the door; {@link
 * org.selectiverenderer.validation.run.RuleCatalogue} knows the packages of all groups of rules,
 * which know nothing of a run. Uses these, {@code validation}, {@code geometry}, {@code x3d} and
 * {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.validation.run;

import org.jspecify.annotations.NullMarked;
