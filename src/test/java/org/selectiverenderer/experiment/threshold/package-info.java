/** Tests of the threshold pilot. */
@org.jspecify.annotations.NullMarked
package org.selectiverenderer.experiment.threshold;
