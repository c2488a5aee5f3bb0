/**
 * Simulated participants of known sensitivity and bias: to test the analysis from end to end, and
 * to find out how many participants a study needs.
 *
 * <p>In: a {@link org.selectiverenderer.statistics.simulation.Model} and a seed. Out: answers, or
 * {@link org.selectiverenderer.statistics.simulation.Power}. The same seed gives the same results
 * whatever the number of cores. Uses the other packages of {@code statistics} but {@code report}.
 */
@NullMarked
package org.selectiverenderer.statistics.simulation;

import org.jspecify.annotations.NullMarked;
