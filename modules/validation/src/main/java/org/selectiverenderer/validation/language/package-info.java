/**
 * Rules of the X3D language, SR1xx: elements, fields, containment, profiles, names, routes and
 * prototypes, all checked against the node catalogue.
 *
 * <p>In: {@code FileContext}. Out: findings. Uses {@code validation}, {@code x3d} and {@code
 * base.problem}.
 */
@NullMarked
package org.selectiverenderer.validation.language;

import org.jspecify.annotations.NullMarked;
