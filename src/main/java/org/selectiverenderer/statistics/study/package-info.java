/**
 * The analyses of a study of recognition memory (thesis 6.4, 6.5): every measure of every area at
 * every level of confidence.
 *
 * <p>In: {@link org.selectiverenderer.statistics.data.Responses} and options. Out: {@link
 * org.selectiverenderer.statistics.study.Study}. Uses the other packages of {@code statistics} but
 * {@code report}.
 */
@NullMarked
package org.selectiverenderer.statistics.study;

import org.jspecify.annotations.NullMarked;
