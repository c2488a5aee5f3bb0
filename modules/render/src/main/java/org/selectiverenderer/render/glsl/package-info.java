/**
 * Translates custom shaders, written for the GLSL of their day and browser, to OpenGL 3.3's core
 * profile; without GL.
 *
 * <p>{@link org.selectiverenderer.render.glsl.GlslTokens} splits a source into tokens; {@link
 * org.selectiverenderer.render.glsl.GlslTranslator} reassembles them under a head that declares
 * what newer versions of GLSL no longer know and what browsers declare themselves. These names and
 * declarations are data in {@code author-names.tsv}. The author's lines are not moved, so that the
 * compiler's messages, which {@link org.selectiverenderer.render.glsl.CompilerLog} reads, can be
 * mapped to lines of the scene.
 *
 * <p>In: the sources of a program's stages. Out: sources to compile. Uses {@code browser.instance},
 * {@code x3d.shader} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.render.glsl;

import org.jspecify.annotations.NullMarked;
