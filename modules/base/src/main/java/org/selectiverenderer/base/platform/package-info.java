/**
 * Describes the computer that runs the program, and starts the program again as a child process.
 *
 * <p>In: system properties, the environment, files of the system. Out: the processor's name, and
 * the command line of a child process, which may be tied to the lifetime of this one. Uses the JDK
 * only.
 */
@NullMarked
package org.selectiverenderer.base.platform;

import org.jspecify.annotations.NullMarked;
