/**
 * Scripts for R that repeat the analyses of a study and do what no library of the JVM does: the
 * mixed probit of single answers, with participants and items random.
 *
 * <p>In: the name of a table of answers, and how rates are corrected. Out: text. Uses {@code
 * statistics.detection}.
 */
@NullMarked
package org.selectiverenderer.statistics.script;

import org.jspecify.annotations.NullMarked;
