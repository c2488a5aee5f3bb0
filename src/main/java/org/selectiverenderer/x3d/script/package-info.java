/**
 * The programs of Script nodes as texts (X3D 4.0, clause 29): which of a node's urls is the one,
 * and whether its text is ECMAScript.
 *
 * <p>In: a node of a file. Out: the text of its program with its place, or why there is none;
 * faults of its language. Nothing is run here: that is {@code runtime.script}. Uses Rhino's parser,
 * for which {@code docs/scripts.md} gives reasons, {@code x3d.files}, {@code x3d.catalogue}, {@code
 * x3d.read} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.x3d.script;

import org.jspecify.annotations.NullMarked;
