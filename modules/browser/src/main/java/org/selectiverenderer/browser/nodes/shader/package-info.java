/**
 * Shader nodes of a running scene (X3D 4.0, clause 31). The fields that their authors declare are
 * uniforms of a program. The renderer compiles the program and tells the node the result, and the
 * node sends its events.
 *
 * <p>In: events, and the results of compiling. Out: events. Uses {@code browser.scene} and {@code
 * x3d.catalogue}.
 */
@NullMarked
package org.selectiverenderer.browser.nodes.shader;

import org.jspecify.annotations.NullMarked;
