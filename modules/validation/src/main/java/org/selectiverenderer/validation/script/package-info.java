/**
 * Rules of Scripts, SR6xx: their interface and their programs, which are parsed and never run.
 *
 * <p>In: {@code FileContext} and {@code SceneContext}. Out: findings. Uses {@code validation},
 * {@code x3d} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.validation.script;

import org.jspecify.annotations.NullMarked;
