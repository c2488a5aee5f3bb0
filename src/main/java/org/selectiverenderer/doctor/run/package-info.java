/**
 * Makes probes, each where it can do no harm to the others, and collects their lines.
 *
 * <p>In: {@link org.selectiverenderer.doctor.Probe}s. Out: {@link
 * org.selectiverenderer.doctor.Diagnosis}es in the order of the probes, after the sum of their
 * limits at the latest. A child process is this program with the probe's name; it prints {@code
 * doctor-line} and a JSON object for each line, and what libraries print between them is kept as
 * the reason of a crash. It ends with the process that began it: that one kills it when it is
 * interrupted, and it looks after itself where that one is killed.
 */
@NullMarked
package org.selectiverenderer.doctor.run;

import org.jspecify.annotations.NullMarked;
