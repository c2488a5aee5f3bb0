/**
 * Rules of the files that a scene names, SR3xx: missing, outside the folders it may name, on the
 * network, in circles.
 *
 * <p>In: {@code SceneView}. Out: findings. Uses {@code validation}, {@code x3d} and {@code
 * base.problem}.
 */
@NullMarked
package org.selectiverenderer.validation.files;

import org.jspecify.annotations.NullMarked;
