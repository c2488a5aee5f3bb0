/**
 * Runs the probes isolated from each other, and collects their results.
 *
 * <p>In: {@link org.selectiverenderer.doctor.Probe}s. Out: {@link
 * org.selectiverenderer.doctor.Diagnosis}es in the order of the probes, after the sum of their
 * limits at the latest. A child process is this program with the probe's name; it prints {@code
 * doctor-line} and a JSON object for each line, and what libraries print between them is kept as
 * the reason of a crash. It ends with its parent: the parent kills it when interrupted, and the
 * child ends by itself when the parent is killed.
 */
@NullMarked
package org.selectiverenderer.doctor.run;

import org.jspecify.annotations.NullMarked;
