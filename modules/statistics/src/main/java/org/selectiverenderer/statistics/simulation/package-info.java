/**
 * Simulated participants of known sensitivity and bias: to test the analysis from end to end, and
 * to estimate how many participants a study needs.
 *
 * <p>In: a {@link org.selectiverenderer.statistics.simulation.SimulationModel} and a seed. Out:
 * answers, or {@link org.selectiverenderer.statistics.simulation.PowerEstimate}. In: printed means
 * ({@link org.selectiverenderer.statistics.simulation.ScoreTarget}). Out: observers with these
 * means ({@link org.selectiverenderer.statistics.simulation.ScoreCalibration}). Power analyses run
 * study by study on the common pool; each study has a seed of its own, so the number of cores
 * changes nothing. Uses the other packages of {@code statistics} but {@code report}, {@code
 * base.decimal} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.statistics.simulation;

import org.jspecify.annotations.NullMarked;
