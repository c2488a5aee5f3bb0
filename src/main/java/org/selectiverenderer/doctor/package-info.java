/**
 * Checks what a machine has and lacks for the program, for its user and for a bug report.
 *
 * <pre>
 *   Probe (what is looked at, how long it may take, whether in a process of its own)
 *     | run.Doctor: each here on a thread of its own, or in a child process; none stops the others
 *     v
 *   Diagnosis (a line: ok, warning or missing; what is there; what to do) --report--> text, JSON
 * </pre>
 *
 * <p>This package contains the common types. Third-party libraries that may crash or hang, above
 * all drivers, are called in child processes, which send each result as soon as it is known.
 * Nothing is changed on the machine, no device is opened that may act on it, and nothing is sent
 * anywhere.
 */
@NullMarked
package org.selectiverenderer.doctor;

import org.jspecify.annotations.NullMarked;
