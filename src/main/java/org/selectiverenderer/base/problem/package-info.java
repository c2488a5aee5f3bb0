/**
 * What is wrong with something that a user made, and where.
 *
 * <p>In: a sentence and a place. Out: {@link org.selectiverenderer.base.problem.Problem}s,
 * collected by {@link org.selectiverenderer.base.problem.Problems} in the order of their places;
 * {@link org.selectiverenderer.base.problem.Spelling} finds the name that somebody probably meant.
 * Uses no other package of ours.
 *
 * <p>What is wrong with a user's file is a {@link Problem}: its severity, file:line:column, and one
 * sentence that says what is wrong and what is done about it. Problems never stop what can still be
 * shown. They are reported in document order, whichever thread found them. Faults of the machine
 * (no such file, no display) are {@code IOException}s and their like with a message of one line;
 * {@code cli} turns both into lines on the standard error stream and the exit status that the
 * command line promises. A stack trace is a fault of the program.
 */
@NullMarked
package org.selectiverenderer.base.problem;

import org.jspecify.annotations.NullMarked;
