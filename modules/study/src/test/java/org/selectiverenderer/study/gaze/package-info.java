/**
 * Tests of {@code study.gaze}: the measures on logs counted by hand, the model on data with known
 * answers, the whole on simulated viewers with known preferences.
 */
@NullMarked
package org.selectiverenderer.study.gaze;

import org.jspecify.annotations.NullMarked;
