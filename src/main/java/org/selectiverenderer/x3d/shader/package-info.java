/**
 * The programs of shaders as texts (X3D 4.0, clause 31): which of a part's urls is the one.
 *
 * <p>In: a ShaderPart or ShaderProgram of a file. Out: its text with its place, or why there is
 * none. What the text says is the business of {@code runtime.render.glsl}. Uses {@code x3d.files},
 * {@code x3d.read} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.x3d.shader;

import org.jspecify.annotations.NullMarked;
