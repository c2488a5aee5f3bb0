/**
 * The images of the scene: thumbnails, sizes, what is missing and the search for it; and the ball
 * that previews a material.
 *
 * <p>In: the session, files that the scene may read. Out: pictures, edits of urls. Uses {@code
 * authoring.images}, {@code x3d}, and of the enricher {@code component}, {@code session}, {@code
 * table}, {@code task} and {@code text}.
 */
@NullMarked
package org.selectiverenderer.enricher.images;

import org.jspecify.annotations.NullMarked;
