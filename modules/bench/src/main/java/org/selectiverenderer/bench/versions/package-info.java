/**
 * Rules for the choice of versions, compared in pictures at equal budgets of triangles: distance,
 * screen-space error, the thesis's rule, and the budget's.
 *
 * <p>In: a scene with versions and a path through it. Out: how unlike the pictures of each rule are
 * to those with all triangles, as JSON and text. Uses {@code walkthrough.budget}, {@code control},
 * {@code browser}, {@code render} and {@code formats.json}.
 */
@NullMarked
package org.selectiverenderer.bench.versions;

import org.jspecify.annotations.NullMarked;
