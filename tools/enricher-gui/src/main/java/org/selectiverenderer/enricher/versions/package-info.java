/**
 * The dialog that makes versions of an object (thesis 4.2.1, Fig 39): vertices by slider, the
 * versions side by side as solids and wireframes, and one undo step that puts them into the scene.
 * {@link org.selectiverenderer.enricher.versions.QualityLevelsMaker} makes levels of texture and
 * shading.
 *
 * <p>In: an object of a document. Out: files of versions, one edit. Uses {@code
 * enricher.component}, {@code enricher.session}, {@code enricher.task}, {@code authoring}, {@code
 * polygon}, {@code geometry}, {@code x3d} and {@code base}.
 */
@NullMarked
package org.selectiverenderer.enricher.versions;

import org.jspecify.annotations.NullMarked;
