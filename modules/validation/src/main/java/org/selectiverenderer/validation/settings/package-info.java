/**
 * The files that a project keeps for the validator: its settings, and a baseline of known findings.
 *
 * <p>In: {@code .selective-renderer-validate.json} and baselines. Out: {@link
 * org.selectiverenderer.validation.ValidationSettings}, and a report without the known findings.
 * Uses {@code validation}, the catalogue of {@code validation.run} for the names of rules, {@code
 * formats.json} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.validation.settings;

import org.jspecify.annotations.NullMarked;
