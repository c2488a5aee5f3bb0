/**
 * Problems found in a user's files, with their locations.
 *
 * <p>In: a sentence and a location. Out: {@link org.selectiverenderer.base.problem.Problem}s,
 * collected by {@link org.selectiverenderer.base.problem.ProblemCollector} in the order of their
 * places; {@link org.selectiverenderer.base.problem.SpellingSuggester} suggests the intended name
 * for a misspelt one. Uses no other package of ours.
 *
 * <p>A {@link Problem} has a severity, file:line:column, and one sentence that says what is wrong
 * and what the program does about it. A problem never keeps the rest of a scene from being shown.
 * Problems are reported in document order, whichever thread found them. Failures of the environment
 * (no such file, no display) are {@code IOException}s and similar exceptions with a one-line
 * message; {@code cli} turns both into lines on the standard error stream and an exit status. A
 * stack trace is always a bug of the program.
 */
@NullMarked
package org.selectiverenderer.base.problem;

import org.jspecify.annotations.NullMarked;
