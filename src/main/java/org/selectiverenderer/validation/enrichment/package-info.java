/**
 * Rules of the enrichment with memory schemata, SR4xx: whether areas and objects in versions do
 * together what their author means (thesis 4.2, 4.3 and 5.4). In: {@code SceneView}. Uses {@code
 * validation}, {@code schema}, {@code polygon.statistics} and {@code x3d}.
 */
@NullMarked
package org.selectiverenderer.validation.enrichment;

import org.jspecify.annotations.NullMarked;
