/**
 * Rules of the enrichment with memory schemata, SR4xx: whether areas and versioned objects work
 * together as their author intends (thesis 4.2, 4.3 and 5.4).
 *
 * <p>In: {@code SceneContext}. Out: findings. Uses {@code validation}, {@code polygon}, {@code
 * schema}, {@code geometry}, {@code x3d} and {@code base}.
 */
@NullMarked
package org.selectiverenderer.validation.enrichment;

import org.jspecify.annotations.NullMarked;
