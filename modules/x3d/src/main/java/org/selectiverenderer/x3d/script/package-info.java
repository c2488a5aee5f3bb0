/**
 * Selects and checks the programs of Script nodes (X3D 4.0, clause 29): the program among a node's
 * text and urls, and its ECMAScript syntax.
 *
 * <p>In: a node of a file. Out: the text of its program with its location, or the reason why there
 * is none; syntax errors. {@code browser.script} runs the programs. Uses Rhino's parser, for which
 * {@code docs/scripts.md} gives reasons, {@code x3d.url}, {@code x3d.catalogue}, {@code x3d.read}
 * and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.x3d.script;

import org.jspecify.annotations.NullMarked;
