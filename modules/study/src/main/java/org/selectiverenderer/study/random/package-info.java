/**
 * Random numbers that depend on a study's seed and a text alone, such as a participant's id, so
 * that orders are the same on every machine.
 *
 * <p>In: a seed and a text. Out: a generator. Uses nothing of the other packages.
 */
@NullMarked
package org.selectiverenderer.study.random;

import org.jspecify.annotations.NullMarked;
