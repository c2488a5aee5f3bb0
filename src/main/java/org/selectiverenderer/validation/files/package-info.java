/**
 * Rules of the files that a scene names, SR3xx: missing, outside the scene's folder, on the
 * network, in circles. In: {@code SceneView}. Uses {@code validation} and {@code x3d}.
 */
@NullMarked
package org.selectiverenderer.validation.files;

import org.jspecify.annotations.NullMarked;
