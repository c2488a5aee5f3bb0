/**
 * Tests whether OpenGL is available and which driver it is, and draws without a window.
 *
 * <p>In: the environment. Out: a current context, a framebuffer of any size, pictures. {@link
 * org.selectiverenderer.render.context.GlAvailability} alone may be used before it is known that
 * there is a display. JOGL's native libraries are unpacked once, beside the program's jar. Uses
 * {@code formats.image}, {@code base.files} and JOGL.
 */
@NullMarked
package org.selectiverenderer.render.context;

import org.jspecify.annotations.NullMarked;
