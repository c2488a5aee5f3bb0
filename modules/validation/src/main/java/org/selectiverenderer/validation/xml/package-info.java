/**
 * Rules of the file and its XML, SR0xx: encoding, well-formedness, prolog and comments.
 *
 * <p>In: {@code FileContext}. Out: findings. Uses {@code validation}, {@code x3d} and {@code
 * base.problem}.
 */
@NullMarked
package org.selectiverenderer.validation.xml;

import org.jspecify.annotations.NullMarked;
