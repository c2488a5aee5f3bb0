/** Tests of the BIDS dataset. */
@NullMarked
package org.selectiverenderer.study.bids;

import org.jspecify.annotations.NullMarked;
