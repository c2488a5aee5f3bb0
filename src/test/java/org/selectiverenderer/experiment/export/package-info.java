/** Tests of the exported tables. */
@NullMarked
package org.selectiverenderer.experiment.export;

import org.jspecify.annotations.NullMarked;
