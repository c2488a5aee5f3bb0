/**
 * What a machine has and lacks for the program, for its user and for a bug report.
 *
 * <pre>
 *   Probe (what is looked at, how long it may take, whether in a process of its own)
 *     | run.Doctor: each here on a thread of its own, or in a child process; none stops the others
 *     v
 *   Diagnosis (a line: ok, warning or missing; what is there; what to do) --report--> text, JSON
 * </pre>
 *
 * <p>This package holds the vocabulary. Libraries of other people that may crash or hang, drivers
 * most of all, are asked in child processes, which send each line as soon as they have it. Nothing
 * is changed on the machine, no device is opened that may act on it, and nothing is sent anywhere.
 */
@NullMarked
package org.selectiverenderer.doctor;

import org.jspecify.annotations.NullMarked;
