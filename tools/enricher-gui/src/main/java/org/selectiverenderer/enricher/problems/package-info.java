/**
 * The live list of the scene's problems, each with a link to its place: findings at once, checks of
 * whole documents in the background.
 *
 * <p>In: a session, checks of whole documents. Out: selections and fixes. Uses {@code
 * enricher.session}, {@code enricher.table}, {@code enricher.task}, {@code authoring}, {@code
 * validation}, {@code x3d.source} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.enricher.problems;

import org.jspecify.annotations.NullMarked;
