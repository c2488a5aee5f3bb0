/**
 * Selects the source texts of shader nodes (X3D 4.0, clause 31).
 *
 * <p>In: a ShaderPart or ShaderProgram of a file. Out: its text with its location, or the reason
 * why there is none. {@code render.glsl} compiles the texts. Uses {@code x3d.url}, {@code x3d.read}
 * and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.x3d.shader;

import org.jspecify.annotations.NullMarked;
