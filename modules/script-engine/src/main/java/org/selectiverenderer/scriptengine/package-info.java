/**
 * Rhino, metered: the classes of Rhino as published, into which {@code build} has inserted calls of
 * {@link org.selectiverenderer.scriptengine.ScriptMeter} at every loop and at the entry of methods,
 * before arrays are made, and in place of methods of the JDK whose work grows with their arguments.
 *
 * <p>A built-in function of Rhino is a loop in Java, which nothing can interrupt from outside:
 * threads of Java cannot be killed. With the meter it stops by itself, at the limits that the
 * {@link org.selectiverenderer.scriptengine.MeteredContext} of the running script sets. Where no
 * such context is current, the meter does nothing.
 *
 * <p>In: scripts that run. Out: calls of {@code MeteredContext.checkLimits}. Uses Rhino only. All
 * state belongs to the context of a thread.
 */
@NullMarked
package org.selectiverenderer.scriptengine;

import org.jspecify.annotations.NullMarked;
