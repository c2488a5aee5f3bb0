/**
 * What is wrong with the scene, live, each a click away from its place.
 *
 * <p>In: a session, checks of whole documents. Out: selections and fixes.
 */
@NullMarked
package org.selectiverenderer.enricher.problems;

import org.jspecify.annotations.NullMarked;
