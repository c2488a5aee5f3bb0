/**
 * The computer that the program runs on, and how it was started.
 *
 * <p>In: system properties, the environment, files of the system. Out: the processor's name, and
 * the command that starts the program a second time, in processes that end with this one if they
 * are to. Uses the JDK only.
 */
@NullMarked
package org.selectiverenderer.base.machine;

import org.jspecify.annotations.NullMarked;
