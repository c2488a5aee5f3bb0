/**
 * How consistent the objects of a scene are with their places, estimated from what participants
 * looked at: an object that does not belong draws longer looks (schema theory; Brewer and Treyens
 * 1981, Loftus and Mackworth 1978, Henderson, Weeks and Hollingworth 1999).
 *
 * <p>In: head logs, and ratings where there are any. Out: for each object and area a degree of
 * consistency with its interval and the evidence behind it. {@link
 * org.selectiverenderer.study.gaze.ViewingData} reads and measures, {@link
 * org.selectiverenderer.study.gaze.ConsistencyEstimator} estimates.
 *
 * <p>Uses {@code study.headlog}, {@code schema}, {@code base} and the linear algebra of Apache
 * Commons Math; no scene, no window.
 */
@NullMarked
package org.selectiverenderer.study.gaze;

import org.jspecify.annotations.NullMarked;
