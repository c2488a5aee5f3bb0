/**
 * The polygon count process (thesis 4.2.1) on a document: replaces an object by a Switch of
 * versions, as an edit that can be undone, or written with the scene's file. Everything is planned
 * first, then written as a transaction.
 *
 * <p>In: a document's snapshot, an object's DEF name, goals. Out: files of versions, an edit. Uses
 * {@code authoring}, {@code authoring.file}, {@code authoring.structure}, {@code models}, {@code
 * models.simplify}, {@code x3d} and {@code base}.
 */
@NullMarked
package org.selectiverenderer.authoring.versions;

import org.jspecify.annotations.NullMarked;
