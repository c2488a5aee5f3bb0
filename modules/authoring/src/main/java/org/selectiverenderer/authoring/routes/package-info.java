/**
 * The ROUTEs of a scene: which fields they connect, what is wrong with them, and edits that add and
 * delete them.
 *
 * <p>In: a document, the catalogue of nodes. Out: routes, fields, edits. Uses {@code authoring},
 * {@code x3d} and {@code base}.
 */
@NullMarked
package org.selectiverenderer.authoring.routes;

import org.jspecify.annotations.NullMarked;
