/**
 * A list of what may be typed, below the caret of a text: Down and Up choose, Enter or Tab takes,
 * Escape closes. What is proposed and what taking means is the caller's. In: proposals, keys. Out:
 * the one taken. For the event dispatch thread.
 */
@NullMarked
package org.selectiverenderer.enricher.proposal;

import org.jspecify.annotations.NullMarked;
