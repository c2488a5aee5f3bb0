/**
 * Rules about the files that a scene refers to, SR3xx: missing files, files outside the allowed
 * folders or on the network, and Inline cycles.
 *
 * <p>In: {@code SceneContext}. Out: findings. Uses {@code validation}, {@code x3d} and {@code
 * base.problem}.
 */
@NullMarked
package org.selectiverenderer.validation.files;

import org.jspecify.annotations.NullMarked;
