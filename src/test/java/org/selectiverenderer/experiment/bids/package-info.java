/** Tests of the BIDS dataset. */
@NullMarked
package org.selectiverenderer.experiment.bids;

import org.jspecify.annotations.NullMarked;
