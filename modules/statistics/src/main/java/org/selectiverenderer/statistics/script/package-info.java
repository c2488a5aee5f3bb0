/**
 * R scripts that repeat the analyses of a study and add one that no JVM library offers: a
 * mixed-effects probit regression of single answers with random participants and items.
 *
 * <p>In: the name of a table of answers, and how rates are corrected. Out: the script as text. Uses
 * {@code statistics.detection}.
 */
@NullMarked
package org.selectiverenderer.statistics.script;

import org.jspecify.annotations.NullMarked;
