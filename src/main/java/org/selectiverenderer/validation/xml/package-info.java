/**
 * Rules of the file and its XML, SR0xx: what is to be known before a file says anything about a
 * scene.
 *
 * <p>In: {@code FileView}. Out: findings. Uses {@code validation}, {@code x3d} and {@code
 * base.problem}.
 */
@NullMarked
package org.selectiverenderer.validation.xml;

import org.jspecify.annotations.NullMarked;
