/**
 * Programs of authors, in the GLSL of their day and browser, as OpenGL 3.3's core profile takes
 * them; without GL.
 *
 * <p>{@link org.selectiverenderer.runtime.render.glsl.GlslTokens} takes a text apart, {@link
 * org.selectiverenderer.runtime.render.glsl.GlslTranslator} puts it together again under a head
 * that declares what newer versions of GLSL no longer know and what browsers declare themselves:
 * names and declarations are data, {@code author-names.tsv}. No line of the author's moves, so that
 * the compiler's messages, which {@link org.selectiverenderer.runtime.render.glsl.CompilerLog}
 * reads, name lines of the scene.
 *
 * <p>In: the texts of a program's stages. Out: texts to compile. Uses {@code runtime.instance},
 * {@code x3d.shader} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.runtime.render.glsl;

import org.jspecify.annotations.NullMarked;
