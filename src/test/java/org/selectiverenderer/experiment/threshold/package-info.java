/** Tests of the threshold pilot. */
@NullMarked
package org.selectiverenderer.experiment.threshold;

import org.jspecify.annotations.NullMarked;
