/** Tests of what is read back of a study. */
@NullMarked
package org.selectiverenderer.experiment.dataset;

import org.jspecify.annotations.NullMarked;
