/**
 * Signal detection: from answers to hit and false-alarm rates, sensitivity d', bias log beta and
 * criterion c (thesis 6.3.1, 6.4; Macmillan and Creelman 2005, Detection Theory). From confidence
 * ratings it also computes the ROC, the area under it and the unequal-variance model.
 *
 * <p>In: {@link org.selectiverenderer.statistics.detection.Response}s. Out: {@link
 * org.selectiverenderer.statistics.detection.DetectionScore}s. Uses Commons Math, {@code
 * statistics.distribution} and, for the places of answers in their file, {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.statistics.detection;

import org.jspecify.annotations.NullMarked;
