/**
 * Shader nodes of a running scene (X3D 4.0, clause 31). The fields that their authors declare are
 * numbers for a program, which whoever draws compiles; it tells the node what came of it, and the
 * node sends its events.
 *
 * <p>In: events, and whether the program is one. Out: events. Uses {@code runtime.scene} and {@code
 * x3d.catalogue}.
 */
@NullMarked
package org.selectiverenderer.runtime.nodes.shader;

import org.jspecify.annotations.NullMarked;
