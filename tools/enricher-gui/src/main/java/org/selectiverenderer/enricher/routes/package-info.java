/**
 * The dialog of the scene's ROUTEs: a table with what is wrong, and the fields to connect.
 *
 * <p>In: the session. Out: edits of ROUTEs. Uses {@code authoring.routes}, {@code x3d}, and of the
 * enricher {@code session}, {@code table} and {@code text}.
 */
@NullMarked
package org.selectiverenderer.enricher.routes;

import org.jspecify.annotations.NullMarked;
