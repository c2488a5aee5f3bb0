/**
 * Compares two pictures of one scene from the same viewpoint: in full detail, and as the preview
 * shows it.
 *
 * <p>The preview draws both, one after the other, and hands them over in one frame; this package
 * lays them out in the component: {@code CompareMode} and {@code ComparisonPainter}, which paints
 * them and holds the position of the line between them. Needs no scene and no GL.
 *
 * <p>In: images, the author's mouse. Out: paint. For the event dispatch thread. Uses {@code
 * enricher.text} and {@code base.decimal}.
 */
@NullMarked
package org.selectiverenderer.enricher.compare;

import org.jspecify.annotations.NullMarked;
