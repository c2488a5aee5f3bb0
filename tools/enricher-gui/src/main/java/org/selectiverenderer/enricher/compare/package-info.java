/**
 * Two pictures of one scene from one place: all polygons, and the scene as the preview shows it.
 *
 * <p>The preview draws both, one after the other, and hands them over in one frame; here is said
 * how they share the component: {@code CompareMode} and {@code CompareView}, which paints them and
 * knows where the line between them is. No scene, no GL.
 *
 * <p>In: images, the author's mouse. Out: paint. For the event dispatch thread. Uses {@code
 * enricher.text} and {@code base.decimal}.
 */
@NullMarked
package org.selectiverenderer.enricher.compare;

import org.jspecify.annotations.NullMarked;
