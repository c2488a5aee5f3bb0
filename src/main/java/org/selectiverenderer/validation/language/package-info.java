/**
 * Rules of the X3D language, SR1xx: elements, fields, containment, profiles, names, routes and
 * prototypes, all by the node catalogue. In: {@code FileView}. Uses {@code validation} and {@code
 * x3d}.
 */
@NullMarked
package org.selectiverenderer.validation.language;

import org.jspecify.annotations.NullMarked;
