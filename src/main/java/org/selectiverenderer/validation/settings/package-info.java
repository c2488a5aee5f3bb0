/**
 * What a project keeps in files for the validator: its settings, and the findings that it lives
 * with.
 *
 * <p>In: {@code .selective-renderer-validate.json} and baselines. Out: {@link
 * org.selectiverenderer.validation.ValidationSettings}, and a report without the findings that were
 * known. Uses {@code validation}, the catalogue of {@code validation.run} for the names of rules,
 * {@code base.json} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.validation.settings;

import org.jspecify.annotations.NullMarked;
